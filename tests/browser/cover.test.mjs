// What is seen before the program is there (cover.js, page.css): the opening sample where the program will draw it, and
// the first visit's card, whose buttons wait for the program.
import assert from "node:assert/strict";
import { test } from "node:test";
import { idle, phone, sharedBrowser, summary, wide } from "../page/browser.mjs";

const browser = sharedBrowser();

// A visit whose requests for these files wait until `let_go()`, or fail.
async function visit({ address = "", held = /evenlift\.wasm/, fail = false, visited = false, ...options } = {}) {
  const context = await browser.browser.newContext({ viewport: wide, colorScheme: "light", ...options });
  const page = await context.newPage();
  let letGo;
  const free = new Promise((done) => {
    letGo = done;
  });
  const root = new URL(browser.server.url).href;
  await context.route("**/*", async (route) => {
    const url = route.request().url();
    if (url.split(/[?#]/)[0] === root || !held.test(url)) return route.continue();
    if (fail) return route.abort();
    await free;
    return route.continue();
  });
  if (visited) await page.addInitScript(() => localStorage.setItem("evenlift.welcomed", "1"));
  await page.goto(browser.server.url + address, { waitUntil: "commit" });
  return { page, letGo, close: () => context.close() };
}

const boxOf = (page, selector) =>
  page
    .locator(selector)
    .first()
    .evaluate((element) => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      return [left, top, right, bottom];
    });

const boxOfObject = (page) =>
  page.evaluate(() => {
    const places = evenlift.state().polygon.map((at) => evenlift.view.to_screen(...at));
    const [x, y] = [0, 1].map((axis) => places.map((place) => place[axis]));
    return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)];
  });

const isNear = (a, b, name) =>
  a.forEach((value, i) =>
    assert.ok(Math.abs(value - b[i]) <= 1.5, `${name}: ${a.map(Math.round)}, ${b.map(Math.round)}`),
  );

test("the HTML alone shows the opening sample and the question", async () => {
  const { page, close } = await visit({ held: /./, fail: true });
  await page.locator(".picture .object").waitFor();
  const [left, top, right, bottom] = await boxOf(page, ".picture .object");
  assert.ok(left >= 0 && top >= 0 && right <= wide.width && bottom <= wide.height && right - left > 400);
  assert.equal(await page.locator(".picture .robot").count(), 6);
  assert.match(await page.locator("#first").innerText(), /where should robots stand/);
  await close();
});

const screens = [
  wide,
  phone,
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 844, height: 390 },
  { width: 360, height: 740 },
];
for (const hasTouch of [false, true]) {
  test(`nothing moves when the program takes over, nor when the card comes${hasTouch ? ", on touch screens" : ""}`, async () => {
    for (const viewport of screens) {
      const name = `${viewport.width} × ${viewport.height}`;
      const { page, letGo, close } = await visit({ viewport, hasTouch });
      await page.evaluate(() => document.fonts.ready);
      await page.waitForFunction(() => document.fonts.size === 2);
      const [picture, card] = [await boxOf(page, ".picture"), await boxOf(page, "#first")];
      letGo();
      await page.waitForFunction(() => window.evenlift?.ready);
      await page.evaluate(() => evenlift.ready);
      isNear(picture, await boxOfObject(page), `the object at ${name}`);
      await page.locator("#welcome").waitFor();
      await idle(page);
      isNear(card, await boxOf(page, "#welcome"), `the card at ${name}`);
      isNear(picture, await boxOfObject(page), `the object beside the card at ${name}`);
      await close();
    }
  });
}

test("for those who know the page, the picture is where it will be without the card", async () => {
  for (const viewport of [wide, phone]) {
    const { page, letGo, close } = await visit({ viewport, visited: true });
    assert.equal(await page.locator("#first").isVisible(), false);
    const picture = await boxOf(page, ".picture");
    letGo();
    await page.waitForFunction(() => window.evenlift?.ready);
    await idle(page);
    isNear(picture, await boxOfObject(page), "the object");
    await close();
  }
});

test("what is pressed on the cover's card waits, says so, and then happens", async () => {
  const { page, letGo, close } = await visit();
  const waits = page.getByText("What you pressed happens as soon as the page is ready.");
  assert.equal(await waits.isVisible(), false);
  await page.getByRole("button", { name: "Take the tour" }).click();
  await page.getByRole("button", { name: "Choose a sample" }).click(); // the last one counts
  await waits.waitFor();
  assert.equal(await page.locator("#first .pressed").innerText(), "Choose a sample");
  letGo();
  await page.locator("#samples").waitFor();
  assert.equal(await page.locator("#first, #welcome, #tour").count(), 0);
  await close();
});

test("a press between the first picture and the card's window happens, too", async () => {
  const { page, letGo, close } = await visit({ held: /windows\.js/ });
  await page.waitForFunction(() => document.querySelector("#cover.done"));
  await page.getByRole("button", { name: "Draw your own" }).click();
  letGo();
  await page.waitForFunction(() => !document.getElementById("first"));
  await idle(page);
  assert.match(await summary(page), /Draw a shape/);
  await close();
});

test("keys and clicks on the cover's picture wait for the program", async () => {
  const { page, letGo, close } = await visit({ visited: true });
  const [left, top, right, bottom] = await boxOf(page, ".picture .robot");
  await page.keyboard.press("d"); // draw
  await page.mouse.click((left + right) / 2, (top + bottom) / 2); // the first vertex
  letGo();
  await page.waitForFunction(() => window.evenlift?.ready);
  await idle(page);
  assert.match(await summary(page), /1 vertex\b|one vertex/);
  await close();
});

test("a link, kept work and a figure begin with a card that says what happens", async () => {
  for (const address of ["#1.c6w4B1wtcH", "?embed=1", "?lesson=edge-pairs"]) {
    const { page, close } = await visit({ address });
    await page.getByText("Opening …").waitFor();
    assert.equal(await page.locator(".picture").isVisible(), false, address);
    assert.equal(await page.locator("#first").isVisible(), false, address);
    await close();
  }
});

test("the cover speaks German before the words have come", async () => {
  const { page, close } = await visit({ address: "?lang=de", held: /words-de|evenlift\.wasm/ });
  await page.getByRole("button", { name: "Roboter selbst aufstellen" }).waitFor();
  assert.match(await page.locator("#first").innerText(), /Wo sollen Roboter stehen/);
  assert.doesNotMatch(await page.locator("#first").innerText(), /robots/);
  await close();
});
