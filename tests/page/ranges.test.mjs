// Teams anywhere in their ranges or chosen for a hold: the program's answers, the panel, a drag along the range.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  controlIfShown,
  drag,
  fragment,
  idle,
  load,
  press,
  program,
  published,
  set,
  sharedBrowser,
  state,
  thrown,
  toScreen,
} from "./browser.mjs";

const browser = sharedBrowser();

test("teams in ranges that are to hold are the program's, bit for bit", async () => {
  const page = await browser.open();
  const cases = [
    ["guitar", { positions: "range" }],
    ["guitar", { positions: "range", goal: "hold" }],
    ["labyrinth", { goal: "hold", teams: 2 }],
    ["thesis-sample-centroid", { metric: "circle", goal: "hold", min_margin: 0.2, teams: 4 }],
    ["square", { positions: "range", teams: "max" }],
    ["grand-piano", { positions: "range", robot: "r=30,reach=20,depth=40,width=60,gap=10", goal: "hold" }],
  ];
  for (const [name, settings] of cases) {
    await load(page, asset(name));
    await set(page, { metric: "area", teams: 3, positions: "best", goal: "cover", min_margin: 0.05 });
    await set(page, settings);
    await idle(page);
    const options = Object.entries(settings).flatMap(([key, value]) => [`--${key.replace("_", "-")}`, String(value)]);
    assert.deepEqual(await state(page), program(name, ...options), `${name}, ${JSON.stringify(settings)}`);
  }
  await page.done();
});

test("positions and goal of teams are chosen in the panel, undone, and kept in the link", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1300 } });
  await load(page, asset("guitar"));
  await idle(page);
  await press(page, "positions");
  await press(page, "Anywhere in the range");
  await idle(page);
  assert.deepEqual(await state(page), program("guitar", "--positions", "range"));
  await press(page, "goals");
  await press(page, "Hold");
  await idle(page);
  const held = program("guitar", "--positions", "range", "--goal", "hold");
  assert.deepEqual(await state(page), held);
  assert.equal(held.goal_reached, true);
  await published(page);
  assert.match(await fragment(page), /^2\./);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.deepEqual(await state(page), program("guitar", "--positions", "range"));
  await page.done();
});

test("a team is dragged along its range with its loads, and reset puts it back", async () => {
  const page = await browser.open();
  await load(page, asset("square"));
  await set(page, { positions: "range" });
  await idle(page);
  const before = await state(page);
  // A press takes a vertex before its robot, so this team has a robot away from vertices.
  const apart = ([px, py]) => before.polygon.every(([vx, vy]) => Math.hypot(vx - px, vy - py) > 40);
  const team = before.teams.findIndex((each) => apart(each.ends[0]));
  assert.ok(team >= 0);
  const other = team === 0 ? 1 : 0;
  const [x, y] = before.teams[team].ends[0],
    [cx, cy] = before.centre_of_mass;
  // Around C, a little to both sides: one is within the range.
  const turned = (by) => [cx + (x - cx) - by * (y - cy), cy + (y - cy) + by * (x - cx)];
  for (const by of [0.05, -0.05])
    await drag(page, await toScreen(page, (await state(page)).teams[team].ends[0]), await toScreen(page, turned(by)));
  await idle(page);
  const moved = await state(page);
  assert.notDeepEqual(moved.teams[team].ends, before.teams[team].ends);
  assert.ok(moved.teams[team].ratio >= 0.8 - 1e-9);
  assert.deepEqual(moved.teams[other], before.teams[other]);
  await press(page, "reset robots");
  await idle(page);
  assert.deepEqual(await state(page), before);
  await page.done();
});

test("set() refuses with a sentence what teams cannot be asked", async () => {
  const page = await browser.open();
  for (const [changes, why] of [
    [{ positions: "any" }, /^The positions must be best or range/],
    [{ metric: "distributed", goal: "hold" }, /^The methods distributed and random/],
  ])
    assert.match(await thrown(page, "set", changes), why);
  await page.done();
});
