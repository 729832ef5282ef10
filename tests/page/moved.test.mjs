// Robots dragged by hand stay in place: in undo, after a reload, in a link, and in the program.
import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  drag,
  evenlift,
  idle,
  link,
  load,
  press,
  published,
  redo,
  reload,
  root,
  set,
  sharedBrowser,
  state,
  toScreen,
  undo,
} from "./browser.mjs";

const browser = sharedBrowser();

// Drags a robot a little about C.
async function turn(page, team, end, by) {
  const {
    teams,
    centre_of_mass: [cx, cy],
  } = await state(page);
  const [x, y] = teams[team].ends[end];
  await drag(page, await toScreen(page, [x, y]), await toScreen(page, [x - by * (y - cy), y + by * (x - cx)]));
  await idle(page);
  return state(page);
}

async function checkKept(page, states) {
  const last = states.at(-1);
  assert.notEqual(last.moved, undefined);
  for (const before of states.slice(0, -1).reverse()) {
    await undo(page);
    assert.deepEqual(await state(page), before, "undo");
  }
  for (const after of states.slice(1)) {
    await redo(page);
    assert.deepEqual(await state(page), after, "redo");
  }
  await published(page);
  await reload(page);
  assert.deepEqual(await state(page), last, "after a reload");
  const shared = await link(page);
  const again = await browser.open({ address: `#${shared}` });
  await idle(again);
  assert.deepEqual(await state(again), last, "from a link");
  await again.done();
  assert.deepEqual(JSON.parse(evenlift("place", shared, "--json", "--candidates")), last, "the program's answer");
  await page.locator("#canvas").focus();
  await undo(page);
  assert.deepEqual(await state(page), states.at(-2), "undo after a reload");
}

test("three balanced robots that were dragged come back by undo, reload and link", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 3 });
  await idle(page);
  await page.locator("#canvas").focus();
  const states = [await state(page)];
  for (const by of [0.08, 0.1]) states.push(await turn(page, 0, 0, by));
  assert.notDeepEqual(states[1].teams, states[2].teams);
  await press(page, "reset robots");
  await idle(page);
  assert.deepEqual(await state(page), states[0]);
  await undo(page);
  await checkKept(page, states);
  await page.done();
});

test("a team that was dragged along its range comes back by undo, reload and link", async () => {
  const page = await browser.open();
  await load(page, asset("guitar"));
  await set(page, { positions: "range" });
  await idle(page);
  await page.locator("#canvas").focus();
  const states = [await state(page)];
  // A press takes a vertex before its robot.
  const far = ([x, y]) => states[0].polygon.every(([vx, vy]) => Math.hypot(vx - x, vy - y) > 15);
  const [one, other] = [...states[0].teams.keys()].filter((team) => far(states[0].teams[team].ends[0]));
  for (const [team, by] of [
    [one, 0.02],
    [other ?? one, -0.02],
    [one, 0.03],
  ]) {
    const now = await turn(page, team, 0, by);
    if (now.moved !== states.at(-1).moved) states.push(now);
  }
  assert.ok(states.length > 2);
  await checkKept(page, states);
  // Settings that affect places put robots back; the weight does not.
  await set(page, { weight: 250 });
  assert.equal((await state(page)).moved, states.at(-2).moved);
  await set(page, { teams: 2 });
  assert.equal((await state(page)).moved, undefined);
  await undo(page);
  assert.equal((await state(page)).moved, states.at(-2).moved);
  await page.done();
});

test("a link with robots that cannot stand there is refused with a sentence", async () => {
  const page = await browser.open();
  const before = await state(page);
  const bad = evenlift("link", "encode", path.join(root, "tests/data/moved_nowhere.json")).trim();
  await assert.rejects(
    load(page, bad),
    /Error: Robots moved by hand: the centroid of the robots is not the centre of mass/,
  );
  assert.deepEqual(await state(page), before);
  await page.done();
});
