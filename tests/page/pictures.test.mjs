// The page's appearance, against kept pictures (expected/). Differing ones are written to the folder EVENLIFT_PICTURES;
// `EVENLIFT_PICTURES=tests/page/expected` renews all, and records the system in expected/drawn-on.txt.
import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { asset, idle, load, phone, press, set, sharedBrowser, tap, toScreen, wide } from "./browser.mjs";
import { openWindow } from "./windows.mjs";

const browser = sharedBrowser({ drawn: true });

const expected = fileURLToPath(new URL("expected/", import.meta.url));
const ofReadme = fileURLToPath(new URL("../../docs/page.png", import.meta.url));
// Systems draw letters and edges slightly differently: up to 1.6 % of a window full of words on Debian 13.
const system =
  /^PRETTY_NAME="?([^"\n]*)/m.exec(existsSync("/etc/os-release") ? readFileSync("/etc/os-release", "utf8") : "")?.[1] ??
  process.platform;
const drawnOn = readFileSync(path.join(expected, "drawn-on.txt"), "utf8").trim();
const tolerance = system === drawnOn ? 0.002 : 0.03;

async function check(page, name) {
  await idle(page);
  const now = await page.screenshot();
  const folder = process.env.EVENLIFT_PICTURES;
  const kept = path.join(expected, `${name}.png`);
  const renew = folder && path.resolve(folder) === path.resolve(expected);
  const { share } = existsSync(kept) && !renew ? await browser.compare(readFileSync(kept), now) : { share: 1 };
  if (share > tolerance && folder) {
    mkdirSync(folder, { recursive: true });
    writeFileSync(path.join(folder, `${name}.png`), now);
  }
  if (renew) writeFileSync(path.join(expected, "drawn-on.txt"), `${system}\n`);
  else assert.ok(share <= tolerance, `${name}: ${(100 * share).toFixed(2)} % of the picture differs`);
  await page.done();
}

test("wide, light: the first sample", async () => check(await browser.open(), "wide-light"));

test("the picture in README is the page as it looks now", () => {
  assert.ok(
    readFileSync(ofReadme).equals(readFileSync(path.join(expected, "wide-light.png"))),
    "please copy tests/page/expected/wide-light.png to docs/page.png",
  );
});

test("wide, dark: the first sample", async () => check(await browser.open({ colorScheme: "dark" }), "wide-dark"));

test("a shape being drawn", async () => {
  const page = await browser.open();
  await idle(page);
  await page.keyboard.press("d");
  for (const at of [
    [220, 200],
    [560, 190],
    [640, 420],
    [400, 610],
  ])
    await page.mouse.click(...at);
  await page.mouse.move(210, 470);
  await check(page, "drawing");
});

test("two methods side by side, and what tips", async () => {
  const page = await browser.open({ colorScheme: "dark" });
  await load(page, asset("aircraft-wing"));
  for (const key of ["f", "k", "k", "k"]) await page.keyboard.press(key);
  await check(page, "compare-dark");
});

test("a step of the lesson", async () => {
  const page = await browser.open();
  await load(page, asset("arrow"));
  await page.keyboard.press("b");
  await set(page, { step: 30 });
  await check(page, "lesson");
});

test("phone: a question of the lesson, dark", async () => {
  const page = await browser.open({
    viewport: phone,
    hasTouch: true,
    isMobile: true,
    deviceScaleFactor: 2,
    colorScheme: "dark",
  });
  await load(page, asset("arrow"));
  await page.keyboard.press("b");
  await set(page, { step: 29 });
  await page.keyboard.press("q");
  await page.keyboard.press("ArrowRight");
  await check(page, "lesson-phone-dark");
});

test("the whole in its frame", async () => {
  const page = await browser.open();
  await load(page, asset("horseshoe"));
  await page.keyboard.press("w");
  await check(page, "whole");
});

test("phone: the first sample", async () => {
  await check(await browser.open({ viewport: phone, hasTouch: true, isMobile: true, deviceScaleFactor: 2 }), "phone");
});

test("candidates, and a robot where the pointer rests", async () => {
  const page = await browser.open({ viewport: wide, hasty: true });
  await load(page, asset("guitar"));
  await page.locator("#canvas").focus();
  await page.keyboard.press("a");
  await idle(page);
  const [x, y] = await page.evaluate(() => evenlift.view.to_screen(...evenlift.state().teams[0].ends[0]));
  await page.mouse.move(x, y);
  await page.evaluate(() => evenliftTimersRing()); // it rests there
  await check(page, "candidates");
});

test("the thesis's sample, dark", async () => {
  const page = await browser.open({ colorScheme: "dark" });
  await load(page, asset("thesis-sample"));
  await check(page, "thesis-dark");
});

test("a polygon that is refused", async () => {
  const page = await browser.open();
  await load(page, "(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n");
  await idle(page);
  const from = await toScreen(page, [400, 150]);
  const to = await toScreen(page, [75, 350]);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 6 });
  await check(page, "refused");
});

test("embedded", async () => {
  await check(await browser.open({ address: "?embed=1", viewport: { width: 640, height: 420 } }), "embedded");
});

test("embedded, with what is not as asked for", async () => {
  const page = await browser.open({ address: "?embed=1", viewport: { width: 480, height: 360 } });
  await set(page, { capacity: 12 });
  await check(page, "embedded-overloaded");
});

test("the keys", async () => {
  const page = await browser.open();
  await openWindow(page, "keys");
  await check(page, "keys");
});

test("the gallery", async () => {
  const page = await browser.open();
  await openWindow(page, "samples");
  await check(page, "gallery");
});

test("the coordinates, dark", async () => {
  const page = await browser.open({ colorScheme: "dark" });
  await load(page, asset("cross"));
  await openWindow(page, "table");
  await check(page, "coordinates-dark");
});

test("phone: open", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  await openWindow(page, "open");
  await check(page, "open-phone");
});

const finger = { hasTouch: true, isMobile: true };

test("a phone on its side, the smallest phone, and a tablet", async () => {
  await check(await browser.open({ viewport: { width: 844, height: 390 }, ...finger }), "phone-on-its-side");
  await check(
    await browser.open({ viewport: { width: 320, height: 568 }, ...finger, colorScheme: "dark" }),
    "small-phone-dark",
  );
  await check(await browser.open({ viewport: { width: 1180, height: 820 }, ...finger }), "tablet");
});

test("phone: the whole sheet", async () => {
  const page = await browser.open({ viewport: phone, ...finger });
  await tap(page, "handle");
  await tap(page, "handle");
  await check(page, "sheet");
});

test("the toolbar's menu", async () => {
  const page = await browser.open({ viewport: phone, ...finger });
  await tap(page, "more");
  await check(page, "menu-phone");
});

test("why a robot stands there, dark", async () => {
  const page = await browser.open({ colorScheme: "dark" });
  await idle(page);
  await page.mouse.click(
    ...(await page.evaluate(() => [...evenlift.view.to_screen(...evenlift.state().teams[1].ends[0])])),
  );
  await page.mouse.move(600, 700);
  await check(page, "why-dark");
});

test("a number that is being typed", async () => {
  const page = await browser.open();
  await press(page, "weight");
  await page.keyboard.type("437.5");
  await check(page, "typed");
});

test("letters of many languages", async () => {
  const page = await browser.open();
  await page.evaluate(() =>
    evenlift.load(
      `title: Łódź – Übung größe\nlink: ${evenlift.link()}\n\n[polygon]\nZażółć gęślą jaźń. α ≤ β ≈ π/2 → „gut“. Привет, ∑ ∞.\n`,
    ),
  );
  await check(page, "letters");
});

test("the first visit, wide and on a phone", async () => {
  await check(await browser.open({ first: true }), "first-visit");
  await check(
    await browser.open({ first: true, viewport: phone, ...finger, colorScheme: "dark" }),
    "first-visit-phone-dark",
  );
});

for (const [name, options] of [
  ["about", {}],
  ["lessons", { colorScheme: "dark" }],
  ["save", {}],
  ["glossary", {}],
]) {
  test(`the window ${name}`, async () => {
    const page = await browser.open(options);
    await openWindow(page, name);
    // The server's port differs each time.
    await page.evaluate(() =>
      document.querySelectorAll("#link").forEach((field) => {
        field.value = "https://example.org/";
      }),
    );
    await check(page, `window-${name}`);
  });
}

test("which of several shapes?", async () => {
  const page = await browser.open();
  const window = await openWindow(page, "open");
  await window
    .locator("textarea")
    .fill(
      '<svg xmlns="http://www.w3.org/2000/svg"><rect id="table" width="120" height="80" rx="10"/><circle id="lid" r="25"/></svg>',
    );
  await window.getByRole("button", { name: "Open", exact: true }).click();
  await check(page, "shapes");
});
