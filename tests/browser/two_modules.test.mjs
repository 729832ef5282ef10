// The program is two modules: the first picture needs only one, and nothing is lost before the other is there.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import {
  evenlift,
  idle,
  link,
  pageFolder,
  phone,
  sample,
  set,
  sharedBrowser,
  state,
  toScreen,
  wide,
} from "../page/browser.mjs";

const browser = sharedBrowser();
const rest = "evenlift_rest.wasm";

// Opens the page and keeps the second module back until release(), at the moment when it is first asked for. `asked`
// lists how it was asked for: "fetch" after the first picture, "xhr" by a call that needs it.
async function openInTwo({ address, answer = (route) => route.continue(), ...options } = {}) {
  const context = await browser.browser.newContext({ viewport: wide, reducedMotion: "reduce", ...options });
  const held = { asked: [], close: () => context.close() };
  const released = new Promise((done) => (held.release = done));
  const first = new Promise((done) => (held.isAsked = done));
  await context.route(`**/${rest}`, async (route) => {
    const kind = route.request().resourceType();
    held.asked.push(kind);
    held.isAsked();
    if (kind === "fetch") await released;
    await answer(route);
  });
  held.page = await browser.open({ context, address, ready: false, quiet: false });
  const ends = held.page.evaluate(() => evenlift.ready).then(() => assert.fail("the second module was not asked for"));
  ends.catch(() => {});
  await Promise.race([first, ends]);
  return held;
}

const encoded = (name, ...options) => `#${evenlift("link", "encode", sample(name), ...options).trim()}`;
const starts = {
  "the opening sample": {},
  "the opening sample on a dark phone": { viewport: phone, colorScheme: "dark", isMobile: true, hasTouch: true },
  "the opening sample in German": { locale: "de-DE" },
  "the opening sample on a fine screen": { deviceScaleFactor: 2.5 },
  "a figure in another page": { address: "?embed=1" },
  "teams by area": { address: encoded("gear", "--teams", "6") },
  "teams by distance with C uncertainty": { address: encoded("guitar", "--metric", "distance", "--com-radius", "3") },
  "distributed teams with a unit": { address: encoded("anchor", "--metric", "distributed", "--unit", "mm") },
  "balanced robots": { address: encoded("horseshoe", "--metric", "balanced", "--robots", "5") },
  "robots with a size": { address: encoded("h-column", "--robot", "r=20,reach=3", "--no-go", "2") },
  "supports on a slope": {
    address: encoded("hexagon", "--supports", "250,67 750,67 1000,500 250,933", "--slope", "4%", "--com-height", "80"),
  },
};
for (const [name, options] of Object.entries(starts)) {
  test(`the first picture needs one module: ${name}`, async () => {
    const held = await openInTwo(options);
    const { page } = held;
    await page.locator("#cover.done").waitFor({ state: "attached" });
    assert.deepEqual(held.asked, ["fetch"]);
    held.release();
    await page.evaluate(() => evenlift.ready);
    assert.deepEqual(page.complaints, []);
    await held.close();
  });
}

// Their first calls need it: nothing blocks the page.
for (const [what, address] of Object.entries({
  "a lesson": () => "?lesson=centroid",
  "a challenge": () => `?challenge=1${encoded("gear")}`,
  "a link with a step": linkWithStep,
})) {
  test(`${what} waits for the second module before it is opened`, async () => {
    const held = await openInTwo({ address: await address() });
    const { page } = held;
    assert.equal(await page.locator("#cover.done").count(), 0);
    held.release();
    await page.evaluate(() => evenlift.ready);
    assert.deepEqual(held.asked, ["fetch"]);
    assert.deepEqual(page.complaints, []);
    await held.close();
  });
}

async function linkWithStep() {
  const page = await browser.open({ address: encoded("gear") });
  await set(page, { step: 2 });
  const address = `#${await link(page)}`;
  await page.done();
  assert.notEqual(address, encoded("gear"), "the link has no step");
  return address;
}

test("a drag before the second module is there waits for it, and takes effect", async () => {
  const address = encoded("hexagon", "--teams", "3");
  const before = await browser.open({ address });
  const { polygon } = await state(before);
  const [x, y] = await toScreen(before, polygon[0]);
  await before.done();

  const held = await openInTwo({ address });
  const { page } = held;
  await page.locator("#cover.done").waitFor({ state: "attached" });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y + 30, { steps: 4 });
  await page.mouse.up();
  held.release();
  await page.evaluate(() => evenlift.ready);
  await idle(page);
  assert.ok(held.asked.includes("xhr"), "nothing needed the second module");
  const moved = (await state(page)).polygon[0];
  assert.notDeepEqual(moved, polygon[0]);
  assert.deepEqual(page.complaints, []);
  await held.close();
});

for (const [how, answer] of Object.entries({
  "does not arrive": (route) => route.fulfill({ status: 503 }),
  "is something else": (route) => route.fulfill({ body: "<p>Log in first", contentType: "text/html" }),
  "is of another version": (route) => route.fulfill({ body: otherVersion(), contentType: "application/wasm" }),
})) {
  test(`a second module that ${how} is not joined: the page says so and loses nothing`, async () => {
    const address = encoded("guitar");
    const held = await openInTwo({ address, answer });
    held.release();
    const { page } = held;
    await page.locator("#problem", { hasText: "The page could not be loaded completely." }).waitFor();
    await assert.rejects(
      page.evaluate(() => evenlift.ready),
      /A part of the page did not arrive/,
    );
    await page.context().unroute(`**/${rest}`);
    await page.reload();
    await page.evaluate(() => evenlift.ready);
    assert.equal(`#${await link(page)}`, address);
    await held.close();
  });
}

// The version is in the name by which the modules share functions.
function otherVersion() {
  const bytes = readFileSync(path.join(pageFolder, rest));
  bytes[bytes.indexOf("primary-") + "primary-".length] ^= 1;
  return bytes;
}
