import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  drag,
  idle,
  link,
  load,
  openDrawers,
  lShape,
  redo,
  reload,
  set,
  sharedBrowser,
  state,
  toScreen,
  undo,
} from "./browser.mjs";
import { noticed } from "./windows.mjs";

const browser = sharedBrowser();

async function reloaded(page) {
  await idle(page);
  await reload(page);
  await page.locator("#canvas").focus();
}

test("after a reload every edit can be undone and done again", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  const links = [await link(page)];
  const edits = [
    () => load(page, asset("horseshoe")),
    () => set(page, { teams: 2 }),
    () => set(page, { metric: "circle", min_ratio: 0.7 }),
    async () =>
      drag(page, await toScreen(page, await page.evaluate(() => evenlift.state().centre_of_mass)), [500, 420]),
    () => load(page, asset("violin")),
    () => set(page, { weight: 437 }),
  ];
  for (const edit of edits) {
    await edit();
    await idle(page);
    links.push(await link(page));
  }
  assert.equal(new Set(links).size, links.length, "each edit changes something");
  for (let i = 0; i < 2; ++i) await undo(page);
  await reloaded(page);
  assert.equal(await link(page), links.at(-3));
  for (const expected of links.slice(-2)) {
    await redo(page);
    assert.equal(await link(page), expected, "redo");
  }
  await reloaded(page);
  for (const expected of links.slice(0, -1).reverse()) {
    await undo(page);
    assert.equal(await link(page), expected, "undo");
  }
  await undo(page);
  assert.equal(await link(page), links[0], "there is nothing more to undo");
  await page.done();
});

test("it says what was undone", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  const steps = [
    [() => set(page, { teams: 2 }), "changed the number of teams"],
    [() => set(page, { weight: 12, seed: 3 }), "changed settings"],
    [() => page.keyboard.press("m"), "changed the method"],
    [() => load(page, asset("arrow")), "opened a polygon"],
    [() => page.keyboard.press("v").then(() => page.keyboard.press("ArrowUp")), "moved a vertex"],
    [() => page.keyboard.press("i"), "added a vertex"],
    [() => set(page, { capacity: 30 }), "changed the capacity"],
    [() => page.keyboard.press("k"), "changed the comparison"],
  ];
  for (const [edit] of steps) {
    await edit();
    await idle(page);
  }
  await reloaded(page);
  for (const [, words] of steps.reverse()) {
    await undo(page);
    assert.equal(await noticed(page), `Undone: ${words}.`);
  }
  await redo(page);
  assert.equal(await noticed(page), "Redone: changed the number of teams.");
  await page.done();
});

test("capacity and comparison are steps of undo, with a reload in between", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  await set(page, { teams: 2 });
  await set(page, { capacity: 20 });
  await set(page, { capacity: 30, teams: 4 });
  await page.keyboard.press("k");
  await reloaded(page);
  await undo(page);
  const now = async () => [(await state(page)).requested_teams, (await state(page)).capacity?.limit];
  assert.deepEqual(await now(), [4, 30], "the comparison alone is gone");
  await undo(page);
  assert.deepEqual(await now(), [2, 20], "teams and capacity were one step");
  await undo(page);
  assert.deepEqual(await now(), [2, undefined]);
  await redo(page);
  assert.deepEqual(await now(), [2, 20]);
  await page.done();
});

test("a link that is opened in a new tab comes after the steps that are kept", async () => {
  const first = await browser.open();
  await load(first, asset("arrow"));
  await set(first, { teams: 2 });
  await idle(first);
  const links = [await link(first)];
  const context = first.context();
  const page = await browser.open({ context, address: "#1.Pq1riQoPLvUJmF2ykWfnDSNVxm2W3yqqGl2Hz55vK9StSPd" });
  await idle(page);
  await page.locator("#canvas").focus();
  await undo(page);
  assert.equal(await link(page), links[0]);
  await undo(page);
  assert.equal((await state(page)).requested_teams, 3);
  await page.done();
  await first.done();
});

test("a polygon that is refused comes back, and its steps do not grow with each reload", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  await load(page, lShape);
  await idle(page);
  await drag(page, await toScreen(page, [400, 150]), await toScreen(page, [75, 350]));
  const good = await link(page);
  const kept = () =>
    page.evaluate(
      () =>
        localStorage
          .getItem("evenlift.history")
          .split("\n")
          .filter((line) => /^[<>]/.test(line)).length,
    );
  await reloaded(page);
  const steps = await kept();
  await reloaded(page);
  await reloaded(page);
  assert.equal(await kept(), steps);
  await undo(page);
  assert.equal(await link(page), good);
  await page.done();
});

test("only the newest steps are kept, within a bound of bytes", async () => {
  const page = await browser.open();
  await page.evaluate(() => {
    for (let i = 0; i < 600; ++i) evenlift.set({ weight: 100 + i });
  });
  await idle(page);
  const count = () =>
    page.evaluate(
      () =>
        localStorage
          .getItem("evenlift.history")
          .split("\n")
          .filter((line) => /^[<>]/.test(line)).length,
    );
  assert.equal(await count(), 500);
  // Full precision makes their link long.
  await page.evaluate(() => {
    for (let k = 0; k < 12; ++k) {
      const points = Array.from(
        { length: 3000 },
        (_, i) => `(${(1000 + k) * Math.cos((i / 1500) * Math.PI)},${(900 + k) * Math.sin((i / 1500) * Math.PI)})`,
      );
      evenlift.load(points.join("\n"));
    }
  });
  await idle(page);
  const length = await page.evaluate(() => localStorage.getItem("evenlift.history").length);
  assert.ok(length > 50000 && length <= 400000, String(length));
  await page.done();
});

test("a kept text that is broken stops nothing; in a frame nothing is kept", async () => {
  const page = await browser.open();
  await set(page, { teams: 2 });
  await idle(page);
  await page.evaluate(() => {
    addEventListener("pagehide", () =>
      sessionStorage.setItem("evenlift.history", "< 999 -1 77 1.abc\n< 0 0 0\nnonsense\n> 1 x y z"),
    );
  });
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  await idle(page);
  assert.equal((await state(page)).requested_teams, 2);
  await page.done();
  const frame = await browser.open({ address: "?embed=1" });
  await set(frame, { teams: 2 });
  await idle(frame);
  assert.deepEqual(
    await frame.evaluate(() => [localStorage, sessionStorage].map((kept) => kept.getItem("evenlift.history"))),
    [null, null],
  );
  await frame.done();
});

test("undo to another object shows all of it, as opening does", async () => {
  const page = await browser.open();
  await load(page, asset("arrow"));
  await idle(page);
  const corner = async () => toScreen(page, (await state(page)).polygon[0]);
  const before = await corner();
  await load(page, "(0,0)\n(9000,0)\n(9000,200)\n(0,200)\n");
  await idle(page);
  await undo(page);
  await idle(page);
  assert.deepEqual(await corner(), before);
  await page.done();
});

test("the comparison survives a reload, and its steps are undone and done again", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  const compared = () =>
    page
      .locator("#mirror")
      .getByRole("combobox", { name: "Compare with" })
      .evaluate((list) => list.selectedOptions[0].text);
  await page.keyboard.press("k");
  await openDrawers(page, "Compare");
  const chosen = await compared();
  assert.notEqual(chosen, "Nothing");
  await reloaded(page);
  await openDrawers(page, "Compare");
  await page.waitForFunction(
    (text) => [...document.querySelectorAll("#mirror select")].some((list) => list.selectedOptions[0]?.text === text),
    chosen,
  );
  await undo(page);
  await idle(page);
  assert.equal(await compared(), "Nothing");
  await redo(page);
  await idle(page);
  assert.equal(await compared(), chosen);
  await load(page, lShape);
  await page.keyboard.press("k");
  await idle(page);
  await page.evaluate(() =>
    addEventListener("pagehide", () =>
      sessionStorage.setItem("evenlift.history", sessionStorage.getItem("evenlift.history").replace(/^= \d+/, "= 77")),
    ),
  );
  await reloaded(page);
  await openDrawers(page, "Compare");
  assert.equal(await compared(), "Nothing", "a method that is not there is not compared with");
  await page.done();
});
