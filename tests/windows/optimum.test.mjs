// The window shows the program's result.
import assert from "node:assert/strict";
import path from "node:path";
import { test } from "node:test";
import { asset, axe, evenlift, idle, load, press, root, set, sharedBrowser, state } from "../page/browser.mjs";

const browser = sharedBrowser();

async function openOptimum(page) {
  await press(page, "compared");
  await press(page, "Optimum …");
  await idle(page);
}

const plainSpaces = (words) => words.replaceAll("\u00a0", " ");
const text = async (page) => plainSpaces(await page.locator("#optimum").innerText());
const rows = async (page) =>
  (
    await page
      .locator("#optimum tbody tr")
      .evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)))
  ).map((cells) => cells.map(plainSpaces));

test("the optimum stands beside the greedy choice, with its picture and its teams", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1000 } });
  for (const [name, teams] of [
    ["guitar", 2],
    ["horseshoe", 3],
  ]) {
    await load(page, asset(name));
    await set(page, { teams });
    await idle(page);
    await openOptimum(page);
    const { greedy, optimum } = JSON.parse(
      evenlift("optimum", path.join(root, "assets/polygons", `${name}.txt`), "--teams", teams, "--json"),
    );
    assert.ok(optimum.proved);
    const expected = [greedy, optimum].map(({ coverage, taken }) => [
      `${(100 * coverage).toFixed(2)} %`,
      taken.map((i) => i + 1).join(", "),
    ]);
    const shown = await rows(page);
    assert.deepEqual(
      shown.map(([, covers, , , candidates]) => [covers, candidates]),
      expected,
    );
    const { loads, closure } = await state(page);
    assert.equal(shown[0][2], name === "guitar" ? `${loads.min.toFixed(1)}–${loads.max.toFixed(1)} kg` : shown[0][2]);
    for (const [, , carries, holds] of shown) {
      assert.match(carries, /^[\d.]+(–[\d.]+)? kg$/);
      assert.match(holds, /^(yes|no|second order)$/);
    }
    assert.equal(shown[0][3] === "yes", closure.form_closure);
    assert.deepEqual(
      shown.map(([first]) => first),
      ["Greedy, by area", "The optimum"],
    );
    assert.match(
      await text(page),
      /It is proved: no choice of this number of teams among these candidates covers more\./,
    );
    assert.match(
      await text(page),
      optimum.coverage - greedy.coverage > 1e-9
        ? /The greedy choice is [\d.]+ points behind it\./
        : /The greedy choice is the best one\./,
    );
    const sizes = await page.locator("#optimum img").evaluateAll((all) => all.map((image) => image.naturalWidth));
    assert.equal(sizes.length, 2);
    assert.ok(
      sizes.every((width) => width > 100),
      "both pictures are drawn",
    );
    await page.evaluate(axe);
    assert.deepEqual(
      await page.evaluate(async () => (await globalThis.axe.run(document)).violations.map(({ id }) => id)),
      [],
      "what axe finds",
    );
    await page.keyboard.press("Escape");
    await idle(page);
  }
  await page.done();
});

test("where the optimum would take too long, a sentence says so", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1000 } });
  const outline = Array.from({ length: 701 }, (_, i) =>
    [Math.cos((2 * Math.PI * i) / 701), Math.sin((2 * Math.PI * i) / 701)].map((x) => (1000 * x).toFixed(3)),
  );
  await load(page, outline.map(([x, y]) => `(${x},${y})`).join("\n"));
  await idle(page);
  await openOptimum(page);
  assert.match(
    await text(page),
    /With \d+ candidates the optimum would take too long\. All of them together cover \d+/,
  );
  assert.deepEqual(
    (await rows(page)).map(([first]) => first),
    ["Greedy, by area", "The best found"],
  );
  await page.done();
});

test("methods that do not choose among candidates are compared by area", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1000 } });
  await load(page, asset("guitar"));
  await set(page, { metric: "balanced", robots: 5 });
  await idle(page);
  await openOptimum(page);
  assert.match(
    await text(page),
    /The method balanced does not choose among candidates, so the same number of teams is chosen by area here\./,
  );
  const { optimum } = JSON.parse(
    evenlift("optimum", path.join(root, "assets/polygons/guitar.txt"), "--teams", 2, "--json"),
  );
  assert.equal((await rows(page))[1][4], optimum.taken.map((i) => i + 1).join(", "));
  await page.done();
});

test("robots with a size do not get into each other's way in the optimum either", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1000 } });
  await load(page, asset("square"));
  await set(page, { teams: 2, robot: "r=100,gap=60" });
  await idle(page);
  await openOptimum(page);
  const { optimum } = JSON.parse(
    evenlift(
      "optimum",
      path.join(root, "assets/polygons/square.txt"),
      "--teams",
      2,
      "--robot",
      "r=100,gap=60",
      "--json",
    ),
  );
  assert.equal((await rows(page))[1][4], optimum.taken.map((i) => i + 1).join(", "));
  await page.done();
});
