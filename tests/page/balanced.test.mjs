// The first answer at once, the search in a worker, and the texts of the panel and the card.
import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  control,
  controlIfShown,
  drag,
  evenlift,
  fragment,
  idle,
  link,
  load,
  press,
  program as placed,
  published,
  reload,
  root,
  sample,
  set,
  sharedBrowser,
  state,
  summary,
  thrown,
  toScreen,
} from "./browser.mjs";

const browser = sharedBrowser();

const program = (name, ...options) => placed(name, "--metric", "balanced", ...options);

test("the search ends at the program's answer, bit for bit", async () => {
  const page = await browser.open();
  const cases = [
    ["grand-piano", { robots: 6 }],
    ["grand-piano", { robots: 5, goal: "cover" }],
    ["thesis-sample", { robots: 3 }],
    ["guitar", { robots: 4 }],
    ["thesis-sample", { robots: 7, min_margin: 0.2, apart: 40, survive: 2 }],
    ["square", { robots: 2 }],
  ];
  for (const [name, settings] of cases) {
    await load(page, asset(name));
    await set(page, { metric: "balanced", ...settings });
    await idle(page);
    const options = Object.entries(settings).flatMap(([key, value]) => [`--${key.replace("_", "-")}`, String(value)]);
    assert.deepEqual(await state(page), program(name, ...options), `${name}, ${JSON.stringify(settings)}`);
  }
  await page.done();
});

test("without workers the start of the search stays, and nothing waits for more", async () => {
  const page = await browser.open({
    script: () => {
      delete globalThis.Worker;
    },
  });
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 6 });
  await idle(page);
  const { teams, search_ended: ended } = await state(page);
  assert.equal(teams[0].ends.length, 6);
  assert.equal(ended, false);
  await page.done();
});

test("how many it takes if any one may fail is counted beside the page, to the program's answer", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", capacity: 20 });
  await idle(page);
  assert.deepEqual(await state(page), program("grand-piano", "--capacity", "20"));
  const words = evenlift("place", sample("grand-piano"), "--metric", "balanced", "--capacity", "20").split("\n")[1];
  assert.match(words, /To allow for any one failure: 9 robots/);
  assert.ok((await summary(page)).includes(words));
  const [kept, unknown] = await page.evaluate(() => {
    const counted = () => evenlift.state().capacity.if_one_fails;
    evenlift.set({ robots: 8 });
    const kept = counted();
    evenlift.set({ capacity: 25 });
    return [kept, counted()];
  });
  assert.equal(kept.robots_needed, 9, "it does not depend on how many there are");
  assert.equal(unknown, null);
  await idle(page);
  assert.deepEqual(await state(page), program("grand-piano", "--robots", "8", "--capacity", "25"));
  // The lesson runs the search, and the number of robots is still computed.
  await set(page, { robots: 5, weight: 90 });
  await page.keyboard.press("b");
  await idle(page);
  const { capacity } = program("grand-piano", "--robots", "5", "--weight", "90", "--capacity", "25");
  assert.deepEqual((await state(page)).capacity, capacity);
  await page.done();
});

test("a count for another capacity or another document is dropped", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", capacity: 20 });
  await idle(page);
  await page.evaluate(() => {
    for (const capacity of [15, 30, 18]) evenlift.set({ capacity });
  });
  await idle(page);
  assert.deepEqual(await state(page), program("grand-piano", "--capacity", "18"));
  await page.evaluate((guitar) => {
    evenlift.set({ capacity: 22 });
    evenlift.load(guitar);
    evenlift.set({ metric: "balanced", capacity: 22 });
  }, asset("guitar"));
  await idle(page);
  assert.deepEqual(await state(page), program("guitar", "--capacity", "22"));
  await page.evaluate(() => {
    evenlift.set({ capacity: 15 });
    evenlift.set({ capacity: null });
  });
  await idle(page);
  assert.equal((await state(page)).capacity, undefined);
  assert.doesNotMatch(await summary(page), /may fail/);
  await page.done();
});

test("during a drag nothing is counted, and after it once", async () => {
  const page = await browser.open({
    script: () => {
      globalThis.counts = 0;
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function (message) {
        if (message.request?.includes("\\ncapacity=")) ++globalThis.counts;
        postMessage.call(this, message);
      };
    },
  });
  const counts = () => page.evaluate(() => globalThis.counts);
  await load(page, asset("thesis-sample"));
  await set(page, { metric: "balanced", robots: 5, capacity: 25 });
  await idle(page);
  assert.equal(await counts(), 1);
  const from = await toScreen(page, [539, 220]);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + 24, from[1] - 12, { steps: 6 });
  await idle(page);
  assert.notDeepEqual((await state(page)).polygon[0], [539, 220]);
  assert.equal(await counts(), 1);
  await page.mouse.up();
  await idle(page);
  assert.equal(await counts(), 2);
  assert.ok((await state(page)).capacity.if_one_fails);
  await page.done();
});

test("the first answer is there at once, and the verdict says that the search goes on", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const first = await page.evaluate(() => {
    evenlift.set({ metric: "balanced", robots: 8 });
    return evenlift.state();
  });
  assert.equal(first.teams[0].ends.length, 8);
  const last = program("grand-piano", "--robots", "8");
  assert.ok(first.coverage < last.coverage, "the start is shown first");
  await idle(page);
  assert.equal((await state(page)).coverage, last.coverage);
  assert.match(await summary(page), /^8 robots carry equal loads of 12\.5\skg \(100\skg in all\)\./);
  assert.doesNotMatch(await summary(page), /The search/);
  await page.done();
});

test("where the start is slow, the page does not wait for it", async () => {
  const page = await browser.open();
  await load(page, asset("comb"));
  const first = await page.evaluate(() => {
    evenlift.set({ metric: "balanced", robots: 4 });
    return evenlift.state();
  });
  assert.deepEqual(first.teams, []);
  // Another start replaces the one under way.
  await set(page, { robots: 4, goal: "cover" });
  await idle(page);
  assert.deepEqual(await state(page), program("comb", "--robots", "4", "--goal", "cover"));
  await page.done();
});

test("undo takes one step, whatever the search found meanwhile", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 6 });
  await idle(page);
  await set(page, { robots: 5 });
  await idle(page);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.deepEqual(await state(page), program("grand-piano", "--robots", "6"));
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal((await state(page)).metric, "area");
  await page.done();
});

test("what a search finds for another document is dropped", async () => {
  const page = await browser.open();
  await page.evaluate(
    ([piano, guitar]) => {
      evenlift.load(piano);
      evenlift.set({ metric: "balanced", robots: 8 });
      evenlift.load(guitar);
      evenlift.set({ metric: "balanced", robots: 5 });
      evenlift.set({ robots: 6 });
    },
    [asset("grand-piano"), asset("guitar")],
  );
  await idle(page);
  assert.deepEqual(await state(page), program("guitar", "--robots", "6"));
  await page.done();
});

test("after a drag the robots are those of the place where it ended", async () => {
  const page = await browser.open();
  await load(page, asset("thesis-sample"));
  await set(page, { metric: "balanced", robots: 5 });
  await idle(page);
  const from = await toScreen(page, [539, 220]);
  await drag(page, from, [from[0] + 24, from[1] - 12]);
  const dragged = await state(page);
  assert.notDeepEqual(dragged.polygon[0], [539, 220]);
  const shown = await link(page);
  const again = await browser.open({ address: `#${shown}` });
  await idle(again);
  assert.deepEqual(await state(again), dragged);
  await again.done();
  await page.done();
});

test("the method, its robots and its goal are chosen in the panel", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await idle(page);
  await press(page, "methods");
  await press(page, "Balanced");
  await idle(page);
  let now = await state(page);
  assert.deepEqual([now.metric, now.teams[0].ends.length], ["balanced", 6]);
  assert.equal(await controlIfShown(page, "teams"), null);
  await press(page, "robots -");
  await idle(page);
  assert.equal((await state(page)).teams[0].ends.length, 5);
  await press(page, "robots");
  await page.keyboard.type("7");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).teams[0].ends.length, 7);
  await press(page, "robots");
  await page.keyboard.type("65");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.match(
    await page.locator("#alert").textContent(),
    /^The number of robots must be a whole number from 2 to 64\.$/,
  );
  await page.keyboard.press("Escape");
  await press(page, "goals");
  await press(page, "Cover");
  await idle(page);
  now = await state(page);
  assert.deepEqual(now, program("grand-piano", "--robots", "7", "--goal", "cover"));
  assert.equal(await controlIfShown(page, "min margin"), null, "a margin is of a hold");
  await page.keyboard.press("t");
  await idle(page);
  assert.equal((await state(page)).teams[0].ends.length, 8);
  await page.done();
});

test("what balanced robots have not is not offered", async () => {
  const page = await browser.open();
  await set(page, { metric: "balanced" });
  await idle(page);
  assert.ok(await control(page, "Chords"));
  assert.equal(await controlIfShown(page, "Candidates"), null);
  await page.done();
});

test("the lesson of balanced robots tells the search, and a link opens it at its step", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 6 });
  await page.keyboard.press("b");
  await idle(page);
  assert.deepEqual(
    (await state(page)).robots ?? (await state(page)).teams,
    program("grand-piano", "--robots", "6").robots ?? program("grand-piano", "--robots", "6").teams,
  );
  const steps = JSON.parse(
    evenlift("trace", path.join(root, "assets/polygons/grand-piano.txt"), "--metric", "balanced", "--json"),
  );
  const settled = steps.findIndex((step) => step.kind === "settled");
  await set(page, { step: settled });
  await idle(page);
  assert.match(await summary(page), /No move of three robots makes the set better/);
  const shared = await link(page);
  const other = await browser.open();
  await load(other, shared);
  await idle(other);
  assert.ok((await summary(other)).includes(steps[settled].caption));
  await other.done();
  await page.done();
});

test("a robot that is pressed says what it bears and why", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 6 });
  await idle(page);
  const at = (await state(page)).teams[0].ends[1];
  await page.mouse.click(...(await toScreen(page, at)));
  await idle(page);
  assert.match(
    await page.locator("#alert").textContent(),
    /^Robot 2 of 6\. It carries: 16\.7\skg of 100\skg\..*centroid of the 6 robots/,
  );
  assert.equal(await controlIfShown(page, "show in lesson"), null);
  await page.done();
});

test("balanced robots are in the link, and what is typed of them comes back after a reload", async () => {
  const page = await browser.open();
  await load(page, asset("thesis-sample"));
  await set(page, { metric: "balanced", robots: 5, goal: "cover", apart: 30 });
  await idle(page);
  await published(page);
  assert.match(await fragment(page), /^2\./);
  const before = await state(page);
  await reload(page);
  assert.deepEqual(await state(page), before);
  await set(page, { metric: "area" });
  assert.match(await link(page), /^1\./);
  await page.done();
});

test("balanced robots are compared with teams, on either side", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await press(page, "compared");
  await press(page, "Balanced");
  await idle(page);
  assert.match(
    await page.locator("#news").textContent(),
    /Compared with balanced: 6 robots carry equal loads of 16\.7/,
  );
  await set(page, { metric: "balanced" });
  await idle(page);
  assert.deepEqual(await state(page), program("grand-piano"));
  assert.match(await page.locator("#news").textContent(), /Compared with area: 6 robots carry /);
  await page.done();
});

test("balanced robots beside teams are as many as those", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { teams: 4 });
  await press(page, "compared");
  await press(page, "Balanced");
  await idle(page);
  assert.match(
    await page.locator("#news").textContent(),
    /Compared with balanced: 8 robots carry equal loads of 12\.5/,
  );
  assert.match(await page.locator("#mirror p", { hasText: /^Robots:/ }).textContent(), /^Robots: Area 8, Balanced 8$/);
  await page.done();
});

test("set() refuses with a sentence what balanced robots cannot be asked", async () => {
  const page = await browser.open();
  const bad = [
    [{ robots: 1 }, /^The number of robots must be a whole number from 2 to 64/],
    [{ robots: 65 }, /robots/],
    [{ robots: 2.5 }, /robots/],
    [{ robots: "6" }, /robots/],
    [{ goal: "best" }, /^The goal must be cover or hold/],
    [{ metric: "random", goal: "hold" }, /^The methods distributed and random choose/],
    [{ min_margin: 2 }, /margin/],
    [{ apart: -1 }, /distance between robots/],
    [{ metric: "balanced", robots: 6, survive: 2 }, /survive/],
  ];
  for (const [changes, why] of bad) assert.match(await thrown(page, "set", changes), why);
  assert.equal((await state(page)).metric, "area");
  await page.done();
});

test("one of three balanced robots is dragged along the edge, the others follow, and reset puts them back", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 3 });
  await idle(page);
  const before = await state(page);
  const from = await toScreen(page, before.teams[0].ends[0]);
  const to = await toScreen(
    page,
    before.teams[0].ends[0].map((x, i) => x + 0.06 * (before.centre_of_mass[i] - x)),
  );
  await page.mouse.move(...from);
  assert.equal(await page.locator("#canvas").getAttribute("data-cursor"), "grab");
  const across = [from[0] + (to[1] - from[1]) * 2, from[1] - (to[0] - from[0]) * 2];
  await drag(page, from, across, 12);
  const now = await state(page);
  const moved = now.teams[0].ends.filter(
    (end, i) => Math.hypot(end[0] - before.teams[0].ends[i][0], end[1] - before.teams[0].ends[i][1]) > 1e-6,
  );
  assert.equal(moved.length, 3, "one is dragged and two follow");
  assert.deepEqual(now.teams[0].loads, before.teams[0].loads);
  for (const axis of [0, 1]) {
    const centroid = now.teams[0].ends.reduce((sum, end) => sum + end[axis], 0) / 3;
    assert.ok(Math.abs(centroid - now.centre_of_mass[axis]) < 1e-6);
  }
  await press(page, "reset robots");
  await idle(page);
  assert.deepEqual(await state(page), before);
  assert.equal(await controlIfShown(page, "reset robots"), null);
  await page.done();
});

test("the picture has no chords but a line from each robot to the centre of mass", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 5 });
  await idle(page);
  const lines = await page.evaluate(
    () => [...new DOMParser().parseFromString(evenlift.svg(), "image/svg+xml").querySelectorAll(".chord")].length,
  );
  assert.equal(lines, 5);
  await page.done();
});
