// window.evenlift, on which other pages and tests may rely.
import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  drag,
  drawsNothing,
  evenlift,
  idle,
  load,
  root,
  set,
  sharedBrowser,
  state,
  thrown,
} from "./browser.mjs";

let page;
const browser = sharedBrowser({
  begin: async () => {
    page = await browser.open();
  },
  end: () => page.done(),
});

test("it has the members of the contract, and no way to change them", async () => {
  const members = await page.evaluate(() => Object.keys(evenlift).sort());
  assert.deepEqual(members, ["frames", "idle", "link", "load", "ready", "set", "state", "svg", "text", "view"]);
  assert.ok(await page.evaluate(() => evenlift.ready instanceof Promise && Object.isFrozen(evenlift)));
});

test("the members that are not ready yet say so", async () => {
  const early = await browser.open({
    ready: false,
    script: () => {
      globalThis.whenDefined = new Promise((resolve) => {
        let kept;
        Object.defineProperty(globalThis, "evenlift", {
          configurable: true,
          get: () => kept,
          set(value) {
            kept = value;
            try {
              value.state();
            } catch (error) {
              resolve(error.message);
            }
          },
        });
      });
    },
  });
  assert.match(await early.evaluate(() => whenDefined), /not ready/);
  await early.evaluate(() => evenlift.ready);
  await early.done();
});

test("set() changes what it names and nothing else", async () => {
  await load(page, asset("thesis-sample"));
  await set(page, { teams: 2, metric: "circle", min_ratio: 0.7, weight: 250, seed: 7 });
  let now = await state(page);
  assert.deepEqual([now.requested_teams, now.metric, now.min_ratio, now.weight, now.seed], [2, "circle", 0.7, 250, 7]);
  assert.deepEqual(now.centre_of_mass, [278, 227]);
  await set(page, { com: [300, 240.5] });
  now = await state(page);
  assert.deepEqual(now.centre_of_mass, [300, 240.5]);
  assert.equal(now.metric, "circle");
  await set(page, { teams: "max" });
  now = await state(page);
  assert.equal(now.requested_teams, now.candidates.length);
  await set(page, { com: null });
  assert.notDeepEqual((await state(page)).centre_of_mass, [300, 240.5]);
  await set(page, {});
});

const refused = [
  [{ colour: "red" }, /colour/],
  [{ teams: 3, colour: "red" }, /colour/],
  [{ toString: 1 }, /toString/],
  [{ teams: 0 }, /team/],
  [{ teams: -1 }, /teams/],
  [{ teams: 2.5 }, /teams/],
  [{ teams: "3" }, /teams/],
  [{ teams: "all" }, /teams/],
  [{ teams: null }, /teams/],
  [{ teams: 1e9 }, /team/],
  [{ metric: "Area" }, /method/],
  [{ metric: "" }, /method/],
  [{ metric: 1 }, /method/],
  [{ min_ratio: 1.01 }, /ratio/],
  [{ min_ratio: -0.1 }, /ratio/],
  [{ min_ratio: NaN }, /ratio/],
  [{ min_ratio: "0.8" }, /ratio/],
  [{ weight: 0 }, /weight/],
  [{ weight: -5 }, /weight/],
  [{ weight: Infinity }, /weight/],
  [{ seed: -1 }, /seed/],
  [{ seed: 1.5 }, /seed/],
  [{ com: [0, 0] }, /centre of mass/i],
  [{ com: [1, 2, 3] }, /centre of mass/i],
  [{ com: "1,2" }, /com|centre of mass/i],
  [{ com: [1, NaN] }, /com|centre of mass/i],
  [{ step: -1 }, /step/],
  [{ step: "2" }, /step/],
  [{ teams: "max", metric: "random" }, /team/i],
  [{ teams: 4, min_ratio: 2 }, /ratio/],
  [{ metric: "area\nteams=9" }, /method/],
];

test("set() refuses what it does not know, and then changes nothing", async () => {
  await load(page, asset("thesis-sample"));
  await set(page, { teams: 2, min_ratio: 0.75 });
  const before = JSON.stringify(await state(page));
  for (const [changes, reason] of refused) {
    const message = await page.evaluate((c) => {
      try {
        evenlift.set(c);
      } catch (error) {
        return error instanceof Error ? error.message : "not an Error";
      }
      return "nothing was thrown";
    }, changes);
    assert.match(message, reason, `set(${JSON.stringify(changes)}) says: ${message}`);
    assert.equal(JSON.stringify(await state(page)), before, `set(${JSON.stringify(changes)}) changed something`);
  }
  for (const nonsense of [null, 3, "teams"]) assert.ok(await thrown(page, "set", nonsense));
});

test("load() reads every format, and refuses with a sentence", async () => {
  const wkt = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))";
  const geojson = '{"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]}';
  for (const text of [wkt, geojson, "(0,0)\n(10,0)\n(10,10)\n(0,10)\n"]) {
    await load(page, text);
    assert.deepEqual((await state(page)).polygon, [
      [0, 0],
      [10, 0],
      [10, 10],
      [0, 10],
    ]);
  }
  await load(page, asset("grand-piano"));
  const before = JSON.stringify(await state(page));
  for (const bad of ["", "hello", "(0,0)\n(1,1)", "(0,0)\n(2,2)\n(2,0)\n(0,2)", "1.AAAA", "9.xyz", "POLYGON EMPTY"]) {
    const message = await thrown(page, "load", bad);
    assert.ok(message && message.length > 8, `load(${JSON.stringify(bad)}) says: ${message}`);
    assert.equal(JSON.stringify(await state(page)), before);
  }
  assert.match(await thrown(page, "load", 5), /text/);
});

test("load() opens as the program does: with the defaults, whatever was set before", async () => {
  await set(page, { teams: 6, metric: "circle" });
  await load(page, asset("boat-hull"));
  const program = JSON.parse(
    evenlift("place", path.join(root, "assets/polygons/boat-hull.txt"), "--json", "--candidates"),
  );
  assert.deepEqual(await state(page), program);
});

test("text() and svg() give the polygon and its picture", async () => {
  await load(page, asset("thesis-sample"));
  assert.equal(await page.evaluate(() => evenlift.text()), asset("thesis-sample").trimEnd() + "\n");
  const drawn = await page.evaluate(() => {
    const svg = new DOMParser().parseFromString(evenlift.svg(), "image/svg+xml");
    return [
      svg.documentElement.nodeName,
      svg.querySelectorAll("parsererror").length,
      svg.querySelectorAll("title").length,
    ];
  });
  assert.deepEqual(drawn, ["svg", 0, 1]);
});

test("view goes from the polygon to the screen and back, and follows the view", async () => {
  const trip = () =>
    page.evaluate(() => {
      const [x, y] = evenlift.view.to_screen(539, 220);
      return [x, y, ...evenlift.view.to_world(x, y)];
    });
  const [x, y, wx, wy] = await trip();
  assert.ok(x > 0 && x < 1280 && y > 0 && y < 800);
  assert.ok(Math.abs(wx - 539) < 1e-9 && Math.abs(wy - 220) < 1e-9);
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -300);
  await idle(page);
  const [zoomedX, zoomedY] = await trip();
  assert.ok(Math.hypot(zoomedX - x, zoomedY - y) < 1, "the point under the pointer stays there");
  await drag(page, [60, 400], [160, 450]);
  const [pannedX, pannedY] = await trip();
  assert.ok(Math.hypot(pannedX - zoomedX - 100, pannedY - zoomedY - 50) < 1.5, "the ground follows the pointer");
});

test("frames stands still while nothing happens", async () => {
  const page = await browser.open({ hasty: true });
  await page.mouse.move(640, 400);
  await page.evaluate(() => evenliftTimersRing()); // the pointer rests: what it is on is explained, once
  await drawsNothing(page);
  const before = await page.evaluate(() => evenlift.frames);
  await set(page, { teams: 4 });
  await idle(page);
  assert.ok((await page.evaluate(() => evenlift.frames)) > before);
  await drawsNothing(page);
  await page.done();
});
