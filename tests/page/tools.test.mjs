import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  control,
  controlIfShown,
  drag,
  drawsNothing,
  idle,
  load,
  openL,
  phone,
  press,
  sharedBrowser,
  state,
  tap,
  toScreen,
} from "./browser.mjs";

const browser = sharedBrowser();

const opened = (options) => openL(browser, options);

const corners = [
  [220, 200],
  [560, 190],
  [640, 420],
  [400, 610],
  [190, 470],
];

test("a shape is drawn by clicks and closed on its first vertex; undo brings the old one back", async () => {
  const page = await opened();
  await page.keyboard.press("d");
  for (const [x, y] of corners) await page.mouse.click(x, y);
  await page.mouse.click(corners[0][0] + 4, corners[0][1] + 3);
  await idle(page);
  const drawn = await state(page);
  assert.equal(drawn.polygon.length, 5);
  assert.equal(drawn.teams.length, 3);
  await page.keyboard.press("Control+z");
  assert.equal((await state(page)).polygon.length, 6);
  await page.done();
});

test("Escape takes back vertex by vertex, and then the tool; nothing has changed", async () => {
  const page = await opened();
  const before = await state(page);
  await page.keyboard.press("d");
  for (const [x, y] of corners.slice(0, 3)) await page.mouse.click(x, y);
  await idle(page);
  for (let i = 0; i < 4; ++i) await page.keyboard.press("Escape");
  await idle(page);
  assert.deepEqual(await state(page), before);
  await page.done();
});

test("crossing edges do not close, and Enter does when they are mended", async () => {
  const page = await opened();
  await page.keyboard.press("d");
  for (const at of [
    [200, 200],
    [500, 500],
    [500, 200],
    [200, 500],
  ])
    await page.mouse.click(...at);
  await idle(page);
  await page.keyboard.press("Enter");
  assert.equal((await state(page)).polygon.length, 6, "still the old one");
  assert.match(await page.locator("#alert").textContent(), /cross/);
  for (let i = 0; i < 2; ++i) await page.keyboard.press("Control+z");
  await page.mouse.click(300, 560);
  await idle(page);
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).polygon.length, 3);
  await page.done();
});

test("on a phone a shape is drawn with a finger", async () => {
  const page = await opened({ viewport: phone, hasTouch: true, isMobile: true });
  await page.keyboard.press("d");
  await idle(page);
  for (const at of [
    [100, 200],
    [300, 220],
    [260, 430],
    [90, 400],
  ]) {
    await page.touchscreen.tap(...at);
    await idle(page);
  }
  await page.touchscreen.tap(102, 203);
  await idle(page);
  assert.equal((await state(page)).polygon.length, 4);
  await page.done();
});

test("snapping puts what is dragged on the grid", async () => {
  const page = await opened();
  await page.keyboard.press("n");
  const from = await toScreen(page, [400, 150]);
  await drag(page, from, [500, 333]);
  const [x, y] = (await state(page)).polygon[2];
  const [toX, toY] = await toScreen(page, [x, y]);
  assert.ok(Math.hypot(toX - 500, toY - 333) < 30, `${[x, y]} is at ${[toX, toY]}`);
  assert.equal(x % 5, 0);
  assert.equal(y % 5, 0);
  await page.done();
});

test("the whole is moved, turned and scaled", async () => {
  const page = await opened();
  const before = await state(page);
  await page.keyboard.press("w");
  await idle(page);
  const at = await toScreen(page, [75, 75]);
  await drag(page, [at[0], at[1]], [at[0] + 60, at[1] - 30]);
  const moved = await state(page);
  assert.notDeepEqual(moved.polygon, before.polygon);
  assert.ok(Math.abs(moved.coverage - before.coverage) < 1e-3);
  await page.keyboard.press("[");
  await page.keyboard.press("}");
  await page.keyboard.press("Escape");
  await idle(page);
  const turned = await state(page);
  assert.ok(Math.abs(turned.coverage - before.coverage) < 1e-3, "the same shape, larger and turned");
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+z");
  assert.deepEqual((await state(page)).polygon, before.polygon);
  await page.done();
});

test("on the smallest phone the frame about the shape is clear of the tool's bar", async () => {
  const page = await browser.open({ viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true });
  await idle(page);
  await page.keyboard.press("w");
  const bar = await control(page, "Done");
  const top = await page.evaluate(() =>
    Math.min(...evenlift.state().polygon.map((p) => [...evenlift.view.to_screen(...p)][1])),
  );
  assert.ok(top > bar.y + bar.height + 8 + 10, `${top} ${JSON.stringify(bar)}`);
  await page.done();
});

test("undo of a shape that was made larger shows it as large as it was", async () => {
  const page = await opened();
  const width = () =>
    page.evaluate(() => {
      const xs = evenlift.state().polygon.map((p) => [...evenlift.view.to_screen(...p)][0]);
      return Math.max(...xs) - Math.min(...xs);
    });
  const before = await width();
  await page.keyboard.press("w");
  for (let i = 0; i < 8; ++i) await page.keyboard.press("}");
  await idle(page);
  for (let i = 0; i < 8; ++i) await page.keyboard.press("Control+z");
  await page.keyboard.press("Escape");
  await idle(page);
  assert.ok((await width()) > 0.69 * before, `${await width()} ${before}`);
  await page.done();
});

test("two methods are compared side by side, and the drawing changes on both sides", async () => {
  const page = await opened({ drawn: true });
  const alone = await page.screenshot();
  await page.keyboard.press("k");
  await idle(page);
  const both = await page.screenshot();
  assert.ok((await browser.compare(alone, both)).share > 0.02);
  for (let i = 0; i < 5; ++i) await page.keyboard.press("k"); // through the other methods
  await idle(page);
  assert.ok((await browser.compare(alone, await page.screenshot())).share < 0.001, "and back");
  await page.done();
});

test("the heat map is an overlay that the link carries", async () => {
  const page = await opened();
  const link = await page.evaluate(() => evenlift.link());
  await page.keyboard.press("f");
  await idle(page);
  const shown = await page.evaluate(() => evenlift.link());
  assert.notEqual(shown, link);
  const other = await browser.open({ address: `#${shown}` });
  assert.equal(await other.evaluate(() => evenlift.link()), shown);
  await other.done();
  await page.done();
});

test("motion ends, and with reduced motion there is none", async () => {
  for (const reducedMotion of ["no-preference", "reduce"]) {
    const page = await opened({ reducedMotion, hasty: true });
    const before = await page.evaluate(() => evenlift.frames);
    await page.keyboard.press("t");
    await idle(page);
    const drawn = await page.evaluate(() => evenlift.frames);
    if (reducedMotion === "reduce") assert.ok(drawn - before < 12, `${drawn - before} frames`);
    await drawsNothing(page, "it comes to rest");
    await page.done();
  }
});

test("a thousand vertices follow a drag", async () => {
  const page = await browser.open();
  const points = Array.from({ length: 1000 }, (_, i) => {
    const a = (2 * Math.PI * i) / 1000;
    const r = 300 + 60 * Math.sin(7 * a) + 20 * Math.sin(31 * a);
    return `(${(r * Math.cos(a)).toFixed(2)},${(r * Math.sin(a)).toFixed(2)})`;
  });
  await load(page, points.join("\n"));
  await idle(page);
  const before = await page.evaluate(() => evenlift.link());
  const at = await toScreen(page, (await state(page)).centre_of_mass);
  await drag(page, [at[0], at[1]], [at[0] + 20, at[1] + 10], 20);
  assert.notEqual(await page.evaluate(() => evenlift.link()), before);
  await page.done();
});

test("keys alone: a vertex is selected, moved, added and removed", async () => {
  const page = await opened();
  await page.keyboard.press("v");
  await page.keyboard.press("ArrowUp");
  assert.ok((await state(page)).polygon[0][1] > 0);
  await page.keyboard.press("i");
  assert.equal((await state(page)).polygon.length, 7);
  await page.keyboard.press("Delete");
  assert.equal((await state(page)).polygon.length, 6);
  await page.done();
});

test("the sample of the thesis says that it can still move, and how", async () => {
  const page = await opened();
  await load(page, asset("thesis-sample"));
  await idle(page);
  await page.waitForFunction(() => /It can still/.test(document.getElementById("summary").textContent));
  await page.done();
});

test("the tool's bar has what fits beside the drawing; the rest is in the toolbar's menu", async () => {
  // [width, height, whether the bar has the switches]
  for (const [width, height, inBar] of [
    [1280, 800, true],
    [900, 1000, true],
    [360, 740, false],
    [740, 360, false],
    [320, 568, false],
  ]) {
    const finger = width < 800 || height < 500;
    const page = await opened({ viewport: { width, height }, hasTouch: finger, isMobile: finger });
    await page.keyboard.press("v");
    const bar = (name) => controlIfShown(page, name);
    const remove = await bar("Remove vertex");
    assert.ok(remove.x >= 0 && remove.x + remove.width <= width);
    const chip = await bar("Snap to axis");
    assert.equal(chip !== null, inBar, `${width} by ${height}`);
    if (chip) assert.ok(chip.x + chip.width <= (await bar("fold")).x, "not under the panel");
    if (!inBar && height > 700) {
      // elsewhere the menu scrolls
      const step = async () => {
        const [before] = (await state(page)).polygon[0];
        await page.keyboard.press("ArrowRight");
        await idle(page);
        return (await state(page)).polygon[0][0] - before;
      };
      const fine = await step();
      await press(page, "more");
      await press(page, "Snap to grid");
      await idle(page);
      assert.ok((await step()) > 2 * fine, "arrows go from dot to dot");
    }
    await page.done();
  }
});

test("on a phone the buttons of a selected vertex stand on the sheet, not over the drawing", async () => {
  for (const [width, height] of [
    [390, 844],
    [320, 568],
  ]) {
    const page = await opened({ viewport: { width, height }, hasTouch: true, isMobile: true });
    const teams = await control(page, "teams");
    await page.keyboard.press("v");
    await idle(page);
    const remove = await control(page, "Remove vertex");
    assert.equal(remove.middle[1], teams.middle[1], "in the row of the teams");
    const count = (await state(page)).polygon.length;
    await tap(page, "Add one after");
    await idle(page);
    assert.equal((await state(page)).polygon.length, count + 1);
    await page.keyboard.press("Escape");
    await idle(page);
    assert.equal(await controlIfShown(page, "Remove vertex"), null);
    assert.equal((await control(page, "teams")).middle[1], teams.middle[1]);
    await page.done();
  }
});
