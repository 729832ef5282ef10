import assert from "node:assert/strict";
import { test } from "node:test";
import { drag, idle, link, load, press, set, sharedBrowser, state, toScreen, undo } from "../page/browser.mjs";

const browser = sharedBrowser();
const ring = (name, ...points) => `${name}${points.map(([x, y]) => `(${x},${y})\n`).join("")}`;
const plate =
  ring("", [0, 0], [300, 0], [300, 200], [0, 200]) +
  ring("Hole:\n", [60, 60], [120, 60], [120, 120], [60, 120]) +
  "Cargo:(250,40) 24 motor\n";

async function openPlate() {
  const page = await browser.open();
  await load(page, plate);
  await set(page, { weight: 60 });
  await idle(page);
  return page;
}

async function click(page, at) {
  const [x, y] = await toScreen(page, at);
  await page.mouse.click(x, y);
  await idle(page);
}

async function dragged(page, from, to) {
  await drag(page, await toScreen(page, from), await toScreen(page, to));
  await idle(page);
  return state(page);
}

test("a dragged weight moves the centre of mass as the lever says, and one undo brings it back", async () => {
  const page = await openPlate();
  const before = await state(page);
  assert.equal(before.total_weight, 84);
  const after = await dragged(page, [250, 40], [100, 160]);
  const [x, y] = after.cargo[0].at;
  assert.ok(Math.hypot(x - 100, y - 160) < 1, `(${x}, ${y})`);
  assert.equal(after.cargo[0].name, "motor");
  after.centre_of_mass.forEach((value, axis) => {
    const lever = (60 * after.own_centre_of_mass[axis] + 24 * after.cargo[0].at[axis]) / 84;
    assert.ok(Math.abs(value - lever) < 1e-9);
  });
  await undo(page);
  assert.deepEqual(await state(page), before);
  await page.done();
});

test("a vertex of a hole is dragged, and a hole is drawn, refused where it crosses, and kept in the link", async () => {
  const page = await openPlate();
  const moved = await dragged(page, [60, 60], [40, 40]);
  assert.ok(Math.hypot(moved.holes[0][0][0] - 40, moved.holes[0][0][1] - 40) < 1);
  assert.ok(moved.own_centre_of_mass[0] > 152, "the larger hole moves the centroid away");
  await page.keyboard.press("d");
  await press(page, "Hole");
  for (const at of [
    [100, 100],
    [200, 100],
    [200, 150],
  ])
    await click(page, at);
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).holes.length, 1, "it would cross the first hole");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.keyboard.press("d");
  await press(page, "Hole");
  for (const at of [
    [180, 100],
    [240, 100],
    [210, 160],
  ])
    await click(page, at);
  await page.keyboard.press("Enter");
  await idle(page);
  const drawn = await state(page);
  assert.equal(drawn.holes.length, 2);
  const address = await link(page);
  await load(page, address);
  await idle(page);
  assert.deepEqual((await state(page)).holes, drawn.holes);
  await page.done();
});

test("weights are placed by a click, typed and named in the table, and removed by Delete", async () => {
  const page = await openPlate();
  await page.keyboard.press("d");
  await press(page, "Cargo");
  await click(page, [150, 30]);
  assert.equal((await state(page)).cargo.length, 2);
  assert.equal((await state(page)).cargo[1].weight, 6, "a tenth of the object's own");
  await page.keyboard.press("Delete");
  await idle(page);
  assert.equal((await state(page)).cargo.length, 1);
  await page.keyboard.press("Escape");
  await page.keyboard.press("e");
  await page.getByRole("button", { name: "Weights" }).click();
  const field = (part) => page.getByLabel(`Weight 1, ${part}`);
  await field("weight").fill("36");
  await field("weight").press("Enter");
  await field("name").fill("big motor");
  await field("name").press("Enter");
  await idle(page);
  const { cargo, total_weight: total } = await state(page);
  assert.deepEqual([cargo[0].weight, cargo[0].name, total], [36, "big motor", 96]);
  await field("weight").fill("-1");
  await field("weight").press("Enter");
  await idle(page);
  assert.equal((await state(page)).cargo[0].weight, 36);
  await field("weight").fill("2e9"); // more than a coordinate may be
  await field("weight").press("Enter");
  assert.equal((await state(page)).cargo[0].weight, 2e9);
  await page.done();
});
