import assert from "node:assert/strict";
import { test } from "node:test";
import { asset, gallery, idle, load, phone, set, sharedBrowser, state, thrown } from "../page/browser.mjs";
import { allClosed, openWindow } from "../page/windows.mjs";

const browser = sharedBrowser();

const focused = (page) =>
  page.evaluate(
    () => document.activeElement.textContent || document.activeElement.id || document.activeElement.ariaLabel,
  );

test("it costs nothing until it is opened, then shows every sample with its outline", async () => {
  const page = await browser.open();
  const asked = () =>
    page.evaluate(
      () => performance.getEntriesByType("resource").filter(({ name }) => /samples|windows|dialogs/.test(name)).length,
    );
  assert.equal(await asked(), 0);
  const root = await openWindow(page, "samples");
  assert.ok((await asked()) > 0);
  const shown = await root
    .locator(".sample")
    .evaluateAll((all) =>
      all.map((sample) => ({
        title: sample.textContent,
        points: sample.querySelector("path").getAttribute("d").split("L").length,
        dot: sample.querySelector("circle") !== null,
      })),
    );
  assert.equal(shown.length, gallery().length);
  assert.ok(shown.every(({ title, points, dot }) => title && points >= 3 && dot));
  const headings = await root.locator("h3").allTextContents();
  assert.ok(headings.includes("Furniture") && headings.length >= 4);
  await page.done();
});

test("a sample keeps method, teams, ratio, weight and what is shown, and undo leads back", async () => {
  const page = await browser.open();
  await load(page, asset("hammer"));
  await set(page, { teams: 2, metric: "circle", min_ratio: 0.6, weight: 40, step: 1 });
  const before = await state(page);
  const root = await openWindow(page, "samples");
  assert.deepEqual(
    await root.locator("[aria-current=true]").allTextContents(),
    ["Claw hammer"],
    "the open sample is marked",
  );
  await root.getByText("Grand piano").click();
  await idle(page);
  await allClosed(page);
  const now = await state(page);
  assert.equal(now.polygon.length, 38);
  for (const name of ["requested_teams", "metric", "min_ratio", "weight"])
    assert.deepEqual(now[name], before[name], name);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.deepEqual(await state(page), before);
  await page.done();
});

test("by key alone: filter, arrows, Enter, Escape", async () => {
  const page = await browser.open();
  const before = await state(page);
  const root = await openWindow(page, "samples");
  assert.equal(await page.evaluate(() => document.activeElement.type), "search");
  await page.keyboard.type("t"); // not the canvas's key
  assert.equal((await state(page)).requested_teams, before.requested_teams);
  await page.keyboard.press("Backspace");
  await page.keyboard.type("wing");
  assert.deepEqual(await root.locator(".sample:visible").allTextContents(), ["Aircraft wing"]);
  await page.locator("#samples input").fill("");
  await page.keyboard.press("ArrowDown");
  assert.equal(await focused(page), "Jigsaw piece");
  await page.keyboard.press("ArrowDown");
  assert.equal(await focused(page), "Grand piano");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  assert.equal(await focused(page), "Oval table top");
  await page.keyboard.press("ArrowLeft");
  assert.equal(await focused(page), "Round table top");
  await page.keyboard.press("End");
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowUp");
  assert.equal(await page.evaluate(() => document.activeElement.type), "search");
  await page.keyboard.type("no such thing");
  await root.getByText("No sample matches.").waitFor();
  await page.keyboard.press("Enter");
  await page.locator("#samples input").fill("heart");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => evenlift.state().polygon.length === 52);
  await allClosed(page);
  assert.equal(await focused(page), "canvas");
  await openWindow(page, "samples");
  await page.keyboard.press("Escape");
  await allClosed(page);
  assert.equal(await focused(page), "canvas");
  assert.equal((await state(page)).polygon.length, 52);
  await page.done();
});

test("under a finger on a phone", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  const root = await openWindow(page, "samples");
  const boxes = await root
    .locator("button:visible")
    .evaluateAll((all) => all.map((b) => b.getBoundingClientRect()).map(({ width, height }) => [width, height]));
  assert.ok(boxes.every(([width, height]) => width >= 44 && height >= 44));
  assert.ok(await root.evaluate((r) => r.scrollWidth <= innerWidth));
  await root.getByText("Violin").tap();
  await page.waitForFunction(() => evenlift.state().polygon.length === 72);
  await allClosed(page);
  await page.done();
});

test("a press beside it closes it", async () => {
  const page = await browser.open();
  await openWindow(page, "samples");
  await page.mouse.click(60, 400);
  await allClosed(page);
  await page.done();
});

test("when the samples cannot be fetched it says so, and tries again", async () => {
  const page = await browser.open({ quiet: false });
  await page.route("**/samples.json", (route) => route.abort());
  await page.locator("#canvas").focus();
  await page.keyboard.press("g");
  await page.getByText("The samples cannot be fetched: the server cannot be reached.").waitFor();
  await page.unroute("**/samples.json");
  await page.getByText("Try again").click();
  await page.locator(".sample").first().waitFor();
  assert.equal(await thrown(page, "set", {}), undefined);
  await page.done();
});
