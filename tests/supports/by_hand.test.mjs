// Robots placed by hand: dragged from any method, kept in undo and links, taken away, and evened out.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  drag,
  evenlift,
  idle,
  link,
  load,
  phone,
  published,
  reload,
  set,
  sharedBrowser,
  state,
  toScreen,
  undo,
} from "../page/browser.mjs";

const browser = sharedBrowser();

// Drags a robot by a part of its way to the centre of mass.
async function inwards(page, robot, part) {
  const { robots, centre_of_mass: centre } = await state(page);
  const at = robots[robot].at;
  const to = at.map((value, axis) => value + part * (centre[axis] - value));
  await drag(page, await toScreen(page, at), await toScreen(page, to));
  await idle(page);
  return state(page);
}

test("a dragged robot of any method takes all over, and one undo brings the method back", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  for (const metric of ["area", "circle", "distributed", "random"]) {
    await set(page, { metric });
    await idle(page);
    const before = await state(page);
    const after = await inwards(page, 1, 0.4);
    assert.equal(after.metric, "given", metric);
    assert.equal(after.robots.length, before.robots.length);
    assert.equal(after.robots[1].place, "beneath");
    await undo(page);
    assert.deepEqual(await state(page), before, metric);
  }
  await page.done();
});

test("what is placed by hand is the program's own result, from a link and after a reload", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const placed = await inwards(page, 0, 0.3);
  const shared = await link(page);
  assert.deepEqual(JSON.parse(evenlift("place", shared, "--json", "--candidates")), placed);
  await published(page);
  await reload(page);
  assert.deepEqual(await state(page), placed);
  await page.done();
});

test("a robot let go outside the object is taken away; even out makes all loads equal", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const before = await inwards(page, 2, 0.3);
  await drag(page, await toScreen(page, before.robots[0].at), [20, 700]);
  await idle(page);
  const after = await state(page);
  assert.equal(after.robots.length, before.robots.length - 1);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Shift+Q");
  await idle(page);
  assert.ok((await state(page)).loads.spread < 1e-6);
  await page.done();
});

test("scripts place robots as arrays or text, and a place outside is refused", async () => {
  const page = await browser.open();
  await load(page, "(0,0)\n(4,0)\n(4,3)\n(0,3)\n");
  await set(page, {
    supports: [
      [0, 0],
      [4, 0],
      [2, 3],
    ],
  });
  await idle(page);
  const loads = (await state(page)).robots.map((robot) => robot.load);
  [25, 25, 50].forEach((load, i) => assert.ok(Math.abs(loads[i] - load) < 1e-9));
  await set(page, { supports: "0,0@30 4,0 2,3@40", snap: 0.01 });
  await idle(page);
  assert.deepEqual((await state(page)).capacity.overloaded, [2]);
  await set(page, { support_capacities: [30, null, 60] });
  await idle(page);
  assert.deepEqual((await state(page)).capacity.overloaded, []);
  const refused = await page.evaluate(() => {
    try {
      evenlift.set({ supports: [[9, 9]] });
    } catch (error) {
      return error.message;
    }
  });
  assert.match(refused, /outside the object/);
  await page.done();
});

test("the first button of the welcome card places robots to play with, also on a phone", async () => {
  for (const options of [{}, { viewport: phone, hasTouch: true, isMobile: true }]) {
    const page = await browser.open({ first: true, ...options });
    await idle(page);
    await page.locator("#welcome").getByRole("button", { name: "Place robots yourself" }).click();
    await idle(page);
    const placed = await state(page);
    assert.equal(placed.metric, "given");
    assert.equal(placed.robots.length, 4);
    await page.done();
  }
});
