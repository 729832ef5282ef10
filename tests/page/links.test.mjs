import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  drag,
  evenlift,
  fragment,
  idle,
  link,
  load,
  program,
  published,
  root,
  sample,
  set,
  sharedBrowser,
  state,
  summary,
  toScreen,
} from "./browser.mjs";

const browser = sharedBrowser();

const encoded = (name, ...options) => evenlift("link", "encode", sample(name), ...options).trim();

test("a link made by the program opens", async () => {
  const page = await browser.open({ address: `#${encoded("guitar", "--teams", "4", "--metric", "circle")}` });
  assert.deepEqual(await state(page), program("guitar", "--teams", "4", "--metric", "circle"));
  await page.done();
});

test("link() is what the program encodes", async () => {
  const page = await browser.open();
  await load(page, asset("thesis-sample"));
  assert.equal(await link(page), encoded("thesis-sample"));
  await set(page, { teams: 5, min_ratio: 0.6, metric: "distance" });
  assert.equal(
    await link(page),
    encoded("thesis-sample", "--teams", "5", "--min-ratio", "0.6", "--metric", "distance"),
  );
  await page.done();
});

test("the address bar follows the work without a history of its own", async () => {
  const page = await browser.open();
  assert.equal(await fragment(page), "");
  const length = await page.evaluate(() => history.length);
  await page.evaluate(() => {
    globalThis.replacements = 0;
    const replace = history.replaceState;
    history.replaceState = function (...args) {
      ++globalThis.replacements;
      return replace.apply(this, args);
    };
  });
  const { centre_of_mass: centre } = await state(page);
  const [x, y] = await toScreen(page, centre);
  const started = Date.now();
  await drag(page, [x, y], [x + 40, y + 30], 60);
  await published(page);
  const seconds = (Date.now() - started) / 1000;
  assert.equal(await page.evaluate(() => history.length), length);
  const replacements = await page.evaluate(() => globalThis.replacements);
  assert.ok(replacements >= 1 && replacements <= 4 * seconds + 2, `${replacements} in ${seconds} s`);
  await page.done();
});

test("a new fragment is opened, and undo leads back", async () => {
  const page = await browser.open();
  const first = JSON.stringify(await state(page));
  await page.evaluate((l) => {
    location.hash = l;
  }, encoded("anchor"));
  await page.waitForFunction((l) => evenlift.link() === l, encoded("anchor"));
  assert.deepEqual(await state(page), program("anchor"));
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal(JSON.stringify(await state(page)), first);
  await page.done();
});

test("hostile links give a message and leave the page working", async () => {
  const good = encoded("thesis-sample");
  const version = good.slice(0, good.indexOf("."));
  // The browser drops line breaks and tabs before code sees them.
  const listed = readFileSync(path.join(root, "tests/data/hostile_links.txt"), "utf8")
    .split("\n")
    .filter((line) => line && !line.startsWith("#"))
    .map((line) => JSON.parse(line.split("\t")[1]))
    .filter((l) => l && l !== "#" && !/[\t\r\n]/.test(l));
  const hostile = [
    ...new Set([
      ...listed,
      good.slice(0, -1),
      good.slice(0, 10),
      `${good}A`,
      `${version}.`,
      ".",
      "99999.AAAA",
      `9${good}`,
      "0.0",
      "<script>alert(1)</script>",
      "%00",
      "constructor",
      "__proto__",
      "1.%31",
      encodeURIComponent(`#${good}`),
      "x".repeat(3000),
      `${version}.${"_".repeat(20000)}`,
      good.split("").reverse().join(""),
      `${good.slice(0, 12)}z${good.slice(13)}`,
    ]),
  ];
  assert.ok(hostile.length >= 30);
  const page = await browser.open();
  const before = JSON.stringify(await state(page));
  for (const bad of hostile) {
    const drawn = await page.evaluate(() => evenlift.frames);
    const shown = await page.evaluate(
      (l) =>
        new Promise((resolve) => {
          addEventListener("hashchange", () => requestAnimationFrame(() => resolve(true)), { once: true });
          const old = location.href;
          location.hash = l;
          if (location.href === old) resolve(false);
        }),
      bad,
    );
    await idle(page);
    assert.equal(JSON.stringify(await state(page)), before, `after ${bad.slice(0, 60)}`);
    if (shown)
      assert.ok((await page.evaluate(() => evenlift.frames)) > drawn, `a message is drawn for ${bad.slice(0, 60)}`);
    assert.match(await page.locator("#alert").textContent(), /cannot be opened/, bad.slice(0, 60));
  }
  await set(page, { teams: 2 });
  assert.equal((await state(page)).teams.length, 2);
  await page.done();
});

test("a bad link at the start gives a message and a page that works", async () => {
  const page = await browser.open({ address: `#${encoded("anchor").slice(0, -3)}` });
  assert.match(
    await page.locator("#alert").textContent(),
    /^This link cannot be opened: the link .* The page shows a sample instead\.$/,
  );
  assert.ok((await state(page)).teams.length > 0);
  await page.done();
});

test("work survives a reload", async () => {
  const page = await browser.open();
  await load(page, asset("violin"));
  await set(page, { teams: 2, min_ratio: 0.55 });
  const before = await state(page);
  await published(page);
  await page.goto(browser.server.url + "?x#");
  await page.evaluate(() => evenlift.ready);
  assert.deepEqual(await state(page), before, "from storage");
  await page.done();
});

test("work survives a reload at once, before anything was written at leisure", async () => {
  const page = await browser.open();
  await set(page, { teams: 5 });
  await set(page, { teams: 4 });
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  assert.equal((await state(page)).requested_teams, 4);
  await page.done();
});

// Browsers may reload the address before the last one written.
test("work survives a reload of the address before the last", async () => {
  const page = await browser.open();
  await set(page, { teams: 5 });
  await published(page);
  const before = await fragment(page);
  await set(page, { teams: 4 });
  await published(page);
  await page.evaluate((fragment) => history.replaceState(null, "", `#${fragment}`), before);
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  assert.equal((await state(page)).requested_teams, 4);
  // Opening a link is not a reload.
  await page.goto("about:blank");
  await page.goto(`${browser.server.url}#${before}`);
  await page.evaluate(() => evenlift.ready);
  assert.equal((await state(page)).requested_teams, 5);
  await page.done();
});

test("a link that is opened does not cost the work that was kept", async () => {
  const page = await browser.open();
  await load(page, asset("hammer"));
  const mine = JSON.stringify(await state(page));
  await published(page);
  await page.goto("about:blank");
  await page.goto(`${browser.server.url}#${encoded("star")}`);
  await page.evaluate(() => evenlift.ready);
  assert.deepEqual(await state(page), program("star"));
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal(JSON.stringify(await state(page)), mine);
  await page.done();
});

test("Copy link puts the whole address on the clipboard", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+c");
  await page.waitForFunction(async () => (await navigator.clipboard.readText()).endsWith(`#${evenlift.link()}`));
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.ok(copied.startsWith(browser.server.url));
  await page.done();
});

test("the summary for screen readers follows the state", async () => {
  const page = await browser.open();
  await load(page, asset("thesis-sample"));
  await page.waitForFunction(() => /Team 1 at/.test(document.getElementById("summary").textContent));
  await set(page, { teams: 1 });
  await page.waitForFunction(() => /^2 robots/.test(document.getElementById("summary").textContent));
  assert.match(await summary(page), /one line|slide|turn/);
  await page.done();
});
