// The page's results equal the program's, to the last bit.
import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import { asset, evenlift, gallery, link, load, program, root, set, sharedBrowser, state } from "./browser.mjs";

let page;
const browser = sharedBrowser({
  begin: async () => {
    page = await browser.open();
  },
  end: () => page.done(),
});

test("it opens on the first sample", async () => {
  assert.deepEqual(await state(page), program(gallery()[0]));
});

test("every sample gives the program's JSON", async () => {
  for (const name of gallery()) {
    await load(page, asset(name));
    assert.deepEqual(await state(page), program(name), name);
  }
});

test("so does every method, with settings of all kinds", async () => {
  const cases = [
    ["circle", { teams: 5, min_ratio: 0.5 }],
    ["distance", { teams: 2, weight: 1234.5 }],
    ["distributed", { teams: 4 }],
    ["random", { teams: 3, seed: 42 }],
    ["area", { teams: "max", min_ratio: 0.95 }],
  ];
  for (const [metric, changes] of cases) {
    for (const name of ["thesis-sample", "guitar", "gear", "snowflake"]) {
      await load(page, asset(name));
      await set(page, { metric, ...changes });
      const options = Object.entries(changes).flatMap(([key, value]) => [`--${key.replace("_", "-")}`, String(value)]);
      assert.deepEqual(await state(page), program(name, "--metric", metric, ...options), `${name}, ${metric}`);
    }
  }
});

// From the program's output: its sentences, then each row of its table.
function said(name, metric, { teams, min_ratio = 0.8, capacity, ...more }) {
  const options = Object.entries({ metric, teams, min_ratio, capacity, ...more })
    .filter(([, value]) => value !== undefined)
    .flatMap(([key, value]) => [`--${key.replace("_", "-")}`, String(value)]);
  const lines = evenlift("place", path.join(root, "assets/polygons", `${name}.txt`), ...options).split("\n");
  const rows = lines
    .map((line) => /^\s+(\d+)\s+(\S+)\s+(\(\S+, \S+\))\s+(\S+)\s+(\(\S+, \S+\))\s+(\S+)/.exec(line))
    .filter(Boolean);
  const of_teams = rows
    .slice(0, 12)
    .map(
      ([, team, ratio, at, load, other, loadThere]) =>
        ` Team ${team} at ${at} and ${other}: ${load} and ${loadThere}\u00A0kg, load ratio ${ratio}.`,
    );
  return [
    lines[0],
    capacity === undefined ? "" : ` ${lines[1]}`,
    ` ${rows.length} team${rows.length === 1 ? "" : "s"} of ${teams} requested, method ${metric === "distributed" ? "equal angles" : metric}, minimum load ratio ${min_ratio}.`,
    ...of_teams,
  ].join("");
}

test("the live region says what the program prints, in the same words and digits", async () => {
  const cases = [
    ["area", { teams: 3 }],
    ["circle", { teams: 1, weight: 1234.5, capacity: 400 }],
    ["distance", { teams: 9, min_ratio: 0.5, capacity: 6.5 }],
    ["distributed", { teams: 4, weight: 99.97 }],
    ["random", { teams: 2, weight: 0.0123, capacity: 0.001 }],
  ];
  for (const name of ["thesis-sample", "grand-piano", "square", "snowflake"]) {
    await load(page, asset(name));
    for (const [metric, changes] of cases) {
      await set(page, { capacity: null, weight: 100, min_ratio: 0.8, ...changes, metric });
      const expected = said(name, metric, changes);
      await page
        .waitForFunction((words) => document.getElementById("summary").textContent === words, expected, {
          timeout: 10000,
        })
        .catch(async () => assert.equal(await page.locator("#summary").textContent(), expected, `${name}, ${metric}`));
    }
  }
  await set(page, { capacity: null });
});

test("units are the program's labels, in the JSON, the words and the link", async () => {
  await load(page, asset("grand-piano"));
  await set(page, { unit: "mm", weight_unit: "lb" });
  assert.deepEqual(await state(page), program("grand-piano", "--unit", "mm", "--weight-unit", "lb"));
  const words = /^6 robots carry 15\.3–18\.0\slb each \(100\slb in all\)\./;
  await page.waitForFunction((words) => words.test(document.getElementById("summary").textContent), words, {
    timeout: 10000,
  });
  const file = path.join(root, "assets/polygons/grand-piano.txt");
  assert.equal(await link(page), evenlift("link", "encode", file, "--unit", "mm", "--weight-unit", "lb").trim());
  const before = await state(page);
  for (const units of [{ unit: "km" }, { weight_unit: "none" }, { unit: 3 }])
    await assert.rejects(set(page, units), /unit/);
  assert.deepEqual(await state(page), before);
  await set(page, { unit: "none", weight_unit: "kg" });
  assert.deepEqual(await state(page), program("grand-piano"));
});

test("a capacity gives the program's JSON, and what is no capacity changes nothing", async () => {
  await load(page, asset("grand-piano"));
  for (const metric of ["area", "distributed", "random"]) {
    await set(page, { metric, capacity: 12.5, weight: 480 });
    assert.deepEqual(
      await state(page),
      program("grand-piano", "--metric", metric, "--weight", "480", "--capacity", "12.5"),
    );
  }
  const before = await state(page);
  for (const capacity of [0, -1, Infinity, NaN, "12", " 3", "0x10", [1], {}, true]) {
    await assert.rejects(set(page, { teams: 1, capacity }), /capacity/i, String(capacity));
  }
  assert.deepEqual(await state(page), before);
  await set(page, { capacity: null });
  assert.equal((await state(page)).capacity, undefined);
});
