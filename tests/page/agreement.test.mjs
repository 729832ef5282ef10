// The page computes what the program computes, to the last bit.
import assert from "node:assert/strict";
import path from "node:path";
import { after, before, test } from "node:test";
import { asset, evenlift, gallery, load, root, set, startBrowser, state } from "./browser.mjs";

let browser;
let page;
before(async () => {
  browser = await startBrowser();
  page = await browser.open();
});
after(async () => {
  await page.done();
  await browser.close();
});

function program(name, ...options) {
  return JSON.parse(evenlift("place", path.join(root, "assets/polygons", `${name}.txt`), "--json", "--candidates", ...options));
}

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
    ["circle", { teams: 5, min_ratio: 0.5 }], ["distance", { teams: 2, weight: 1234.5 }],
    ["distributed", { teams: 4 }], ["random", { teams: 3, seed: 42 }], ["area", { teams: "max", min_ratio: 0.95 }],
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
