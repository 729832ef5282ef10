// The first visit: the card that says what this is, and the tour.
import assert from "node:assert/strict";
import { test } from "node:test";
import { asset, idle, link, load, phone, reload, set, sharedBrowser, thrown } from "../page/browser.mjs";
import { allClosed, violations } from "../page/windows.mjs";

const browser = sharedBrowser();

const card = (page) => page.locator("#welcome");
const box = (page, selector) => page.locator(selector).evaluate((e) => {
  const { left, top, right, bottom } = e.getBoundingClientRect();
  return { left, top, right, bottom };
});
const apart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;

for (const [width, height, touch] of [[320, 568, true], [390, 844, true], [740, 360, true], [844, 390, true], [1024, 768, false], [820, 1180, true], [1440, 900, false], [3840, 2160, false]]) {
  test(`at ${width} by ${height} the card covers neither the object nor a control`, async () => {
    const page = await browser.open({ first: true, viewport: { width, height }, hasTouch: touch, isMobile: touch });
    await idle(page);
    await card(page).waitFor();
    await idle(page);
    const place = await box(page, "#welcome");
    assert.ok(place.left >= 0 && place.top >= 0 && place.right <= width && place.bottom <= height, JSON.stringify(place));
    const things = await page.evaluate(() => {
      const state = evenlift.state();
      const points = [...state.teams.flatMap(({ ends }) => ends), ...evenlift.text().matchAll(/^\(([^,]+),([^)]+)\)/gm)].map((p) => evenlift.view.to_screen(Number(p.at(-2)), Number(p.at(-1))));
      const controls = ["Samples", "Draw", "Undo", "Copy link", "Zoom in", "Show all of the object", "Coordinates", "teams +", "teams -", "ratio"].map((name) => evenlift.view.control(name)).filter(Boolean);
      return [
        { left: Math.min(...points.map((p) => p.x)) - 12, right: Math.max(...points.map((p) => p.x)) + 12, top: Math.min(...points.map((p) => p.y)) - 12, bottom: Math.max(...points.map((p) => p.y)) + 12 },
        ...controls.map(({ x, y, width: w, height: h }) => ({ left: x, top: y, right: x + w, bottom: y + h })),
      ];
    });
    assert.ok(things.length > 6);
    for (const thing of things) assert.ok(apart(place, thing), `${JSON.stringify(place)} covers ${JSON.stringify(thing)}`);
    const [one, other] = await page.evaluate(() => evenlift.state().teams[0].ends.map((at) => [...evenlift.view.to_screen(...at)]));
    const between = Math.hypot(one[0] - other[0], one[1] - other[1]);
    assert.ok(between >= 84, `the object is to be seen between its robots: ${between} pixels`);
    const sentence = await box(page, "#welcome p");
    assert.ok(sentence.bottom - sentence.top < 64, "the sentence is no column of words");
    const targets = await page.locator("#welcome button").evaluateAll((all) => all.map((b) => b.getBoundingClientRect().height));
    if (touch) assert.ok(Math.min(...targets) >= 44, String(targets));
    assert.equal(await page.evaluate(() => document.activeElement.id !== "welcome" && document.activeElement.closest("#welcome") === null), true, "it takes no focus");
    await page.done();
  });
}

test("the card goes with the first edit, and does not come back", async () => {
  const page = await browser.open({ first: true });
  await idle(page);
  await card(page).waitFor();
  await set(page, { teams: 2 });
  await idle(page);
  assert.equal(await card(page).count(), 0);
  await reload(page);
  assert.equal(await card(page).count(), 0);
  await page.done();
});

test("closed without an edit, it does not come back either; its key brings it back, with the focus", async () => {
  const page = await browser.open({ first: true });
  await idle(page);
  await page.getByRole("region", { name: "How to begin" }).getByRole("button", { name: "Close" }).click();
  assert.equal(await card(page).count(), 0);
  await reload(page);
  assert.equal(await card(page).count(), 0);
  await page.locator("#canvas").focus();
  await page.keyboard.press("W");
  await card(page).waitFor();
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Draw your own");
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await card(page).count(), 0);
  assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
  await page.done();
});

test("there is no card for those who follow a link, or see a figure in an article, or come for a lesson", async () => {
  const shared = "1.Pq1riQoPLvUJmF2ykWfnDSNVxm2W3yqqGl2Hz55vK9StSPd";
  for (const address of [`#${shared}`, `?embed=1#${shared}`, "?embed=1", "?lesson=moved"]) {
    const page = await browser.open({ first: true, address });
    await idle(page);
    assert.equal(await card(page).count(), 0, address);
    await page.done();
  }
});

test("the ways to begin: drawing, the gallery, the tour", async () => {
  const page = await browser.open({ first: true });
  await idle(page);
  await card(page).getByRole("button", { name: "Draw your own" }).click();
  await idle(page);
  assert.equal(await card(page).count(), 0);
  for (const at of [[300, 300], [500, 300], [400, 500]]) await page.mouse.click(...at);
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal(await page.evaluate(() => evenlift.text().trim().split("\n").length), 3, "clicks draw, and the keys are the canvas's");
  await page.keyboard.press("W");
  await card(page).getByRole("button", { name: "Choose a sample" }).click();
  await page.locator("#samples .sample").first().waitFor();
  await page.keyboard.press("Escape");
  await allClosed(page);
  await page.keyboard.press("W");
  await card(page).getByRole("button", { name: "Take the tour" }).click();
  await page.locator("#tour").waitFor();
  await page.done();
});

for (const [how, options] of [["wide", {}], ["on a phone", { viewport: phone, hasTouch: true, isMobile: true }]]) {
  test(`the tour, ${how}: each stop is on the screen, keys lead through it, and the document stays as it is`, async () => {
    const page = await browser.open(options);
    await load(page, asset("horseshoe"));
    await idle(page);
    const before = await link(page);
    const frames = [];
    await page.keyboard.press("W");
    await card(page).getByRole("button", { name: "Take the tour" }).click();
    const tour = page.locator("#tour");
    await tour.waitFor();
    const count = Number(/of (\d+)/.exec(await tour.textContent())[1]);
    assert.ok(count >= 6 && count <= 9, String(count));
    for (let i = 0; i < count; ++i) {
      await idle(page);
      const { left, top, right, bottom } = await box(page, "#tour");
      const [width, height] = await page.evaluate(() => [innerWidth, innerHeight]);
      assert.ok(left >= 0 && top >= 0 && right <= width && bottom <= height, `stop ${i + 1}: ${[left, top, right, bottom]}`);
      if (await page.locator(".tour-ring").isVisible()) {
        assert.ok(apart(await box(page, "#tour"), await box(page, ".tour-ring")) || i === 2, `stop ${i + 1} covers what it points at`);
      }
      frames.push(await tour.locator("h2").textContent());
      assert.match(await tour.textContent(), new RegExp(`${i + 1} of ${count}`));
      if (i === 1) {
        await page.keyboard.press("ArrowLeft");
        assert.equal(await tour.locator("h2").textContent(), frames[0]);
        await page.keyboard.press("ArrowRight");
      }
      await page.keyboard.press("Enter");  // Next has the focus
    }
    await idle(page);
    assert.equal(await tour.count(), 0);
    assert.equal(new Set(frames).size, count);
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
    assert.equal(await link(page), before);
    await page.done();
  });
}

test("card and tour have no fault that axe finds, light and dark", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await browser.open({ first: true, colorScheme, reducedMotion: "reduce" });
    await idle(page);
    await card(page).waitFor();
    assert.deepEqual(await violations(page), [], `the card, ${colorScheme}`);
    await card(page).getByRole("button", { name: "Take the tour" }).click();
    await page.locator("#tour").waitFor();
    assert.deepEqual(await violations(page), [], `the tour, ${colorScheme}`);
    await page.done();
  }
});

test("Escape leaves the tour, and nothing moves for those who asked for less motion", async () => {
  const page = await browser.open({ reducedMotion: "reduce" });
  await idle(page);
  await page.keyboard.press("W");
  assert.equal(await card(page).evaluate((root) => root.getAnimations({ subtree: true }).length), 0);
  await card(page).getByRole("button", { name: "Take the tour" }).click();
  await page.locator("#tour").getByRole("button", { name: "Next" }).click();
  assert.equal(await page.evaluate(() => document.getAnimations().filter((a) => a.effect.target.closest("#tour, .tour-ring")).length), 0);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#tour").count(), 0);
  assert.equal(await thrown(page, "set", { teams: 2 }), undefined);
  await page.done();
});
