// Sized robots: typed, drawn, no-go edges marked with the brush, undone, and as in the program.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  control,
  drag,
  idle,
  link,
  load,
  press,
  program,
  set,
  sharedBrowser,
  state,
  thrown,
  toScreen,
} from "./browser.mjs";

const browser = sharedBrowser();

test("set() gives robots a size and marks edges, and the placement is the program's", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const points = await state(page);
  await set(page, { robot: "r=30,reach=20,depth=40,width=60,gap=10", no_go: "38,2:0.25-0.75" });
  await idle(page);
  assert.deepEqual(
    await state(page),
    program("grand-piano", "--robot", "r=30,reach=20,depth=40,width=60,gap=10", "--no-go", "38,2:0.25-0.75"),
  );
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.deepEqual(await state(page), points, "one step of undo");
  assert.match(await thrown(page, "set", { robot: "r=-1" }), /^The size of a robot must be none or some of/);
  assert.match(
    await thrown(page, "set", { robot: "depth=5000" }),
    /^No edge has room for a hand of depth 5000 and width 0/,
  );
  assert.match(await thrown(page, "set", { no_go: "99" }), /^There is no edge 99; the polygon has 38/);
  await page.done();
});

test("the size is typed in the panel, and links carry it", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await page.keyboard.press("Shift+H");
  await page.waitForFunction(() => document.activeElement?.tagName === "INPUT"); // the section opens first
  await page.keyboard.type("30");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.deepEqual((await state(page)).robot, { radius: 30, reach: 0, depth: 0, width: 0, gap: 0 });
  const kept = await link(page);
  assert.match(kept, /^2\./);
  await set(page, { robot: "none" });
  await load(page, kept);
  await idle(page);
  assert.equal((await state(page)).robot.radius, 30);
  await page.done();
});

test("the brush marks edges with the mouse, and undo takes it back", async () => {
  const page = await browser.open();
  await load(page, asset("square"));
  await page.keyboard.press("Shift+N");
  await idle(page);
  const [from, to] = [await toScreen(page, [300, 0]), await toScreen(page, [700, 0])];
  await drag(page, from, to);
  await idle(page);
  const [[edge, begin, end, why]] = (await state(page)).unusable;
  assert.deepEqual([edge, why], [1, "no_go"]);
  assert.ok(Math.abs(begin - 0.3) < 0.05 && Math.abs(end - 0.7) < 0.05, `${begin} to ${end}`);
  assert.match((await state(page)).no_go, /^1:0\.\d{1,4}-0\.\d{1,4}$/, "numbers that a person can read in the panel");
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal((await state(page)).unusable, undefined);
  // A click takes the whole edge.
  await page.mouse.click(...to);
  await idle(page);
  assert.equal((await state(page)).no_go, "1");
  await page.keyboard.press("Escape");
  await page.done();
});

test("marks are typed for those who do not paint", async () => {
  const page = await browser.open();
  await load(page, asset("square"));
  await press(page, "no go");
  await idle(page);
  await page.keyboard.press("Control+a");
  await page.keyboard.type("3,1:0.25-0.75");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).no_go, "3,1:0.25-0.75");
  assert.ok(await control(page, "mark edges"));
  await page.done();
});

test("the radius has a slider, for the pointer and for keys, and is typed, too", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1300 } });
  await load(page, asset("square"));
  const {
    x,
    width,
    middle: [, y],
  } = await control(page, "radius");
  await drag(page, [x + 9, y], [x + width / 2, y]);
  await idle(page);
  const radius = async () => (await state(page)).robot?.radius ?? 0;
  const slid = await radius();
  assert.ok(slid >= 60 && slid <= 80, `${slid}: half of a tenth of 1414`);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal(await radius(), 0, "a drag is one step of undo");
  // An HTML slider for screen readers.
  const slider = page.getByRole("slider", { name: "Radius of a robot, as a slider" });
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await idle(page);
  assert.equal(await radius(), 1);
  await press(page, "robot radius");
  await idle(page);
  await page.keyboard.press("Control+a");
  await page.keyboard.type("200");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal(await radius(), 200, "more than the slider has");
  await page.done();
});

test("the view that fits leaves room for the robots' bodies", async () => {
  const page = await browser.open();
  await load(page, asset("square"));
  await set(page, { robot: "r=90", metric: "balanced", robots: 4 });
  await idle(page);
  const { robots } = await state(page);
  assert.equal(robots.length, 4);
  for (const {
    stand: [sx, sy],
  } of robots) {
    const [px, py] = await toScreen(page, [sx, sy]);
    const [rim] = await toScreen(page, [sx + 90, sy]);
    const r = rim - px;
    assert.ok(px - r > 0 && py - r > 60 && py + r < 800, `${[px, py, r]}`);
  }
  await page.done();
});
