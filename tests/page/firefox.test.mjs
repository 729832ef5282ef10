// Firefox, through WebDriver BiDi: opening, drawing, link and drag. It has WebGL only with a screen, or with Xvfb.
//   EVENLIFT_FIREFOX  Firefox; without it, these tests are skipped
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { after, before, test } from "node:test";
import puppeteer from "puppeteer-core";
import { serve } from "../../web/serve.mjs";
import { idle, pageFolder, reload } from "./browser.mjs";

const executablePath = process.env.EVENLIFT_FIREFOX;
const skip = executablePath ? false : "no Firefox here";

let screen;
let server;
let browser;

// Xvfb chooses a free display, and reports its number.
async function startScreen() {
  screen = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const failed = once(screen, "error").then(([error]) => {
    throw error;
  });
  const [number] = await Promise.race([once(screen.stdio[3], "data"), failed]);
  return `:${String(number).trim()}`;
}

before(async () => {
  if (skip) return;
  server = await serve(pageFolder, 0);
  const DISPLAY = process.env.DISPLAY || (await startScreen());
  browser = await puppeteer.launch({
    browser: "firefox",
    executablePath,
    headless: false,
    env: { ...process.env, DISPLAY },
    // Without graphics hardware, Firefox avoids WebGL by default.
    extraPrefsFirefox: { "webgl.force-enabled": true, "widget.dmabuf.force-enabled": false },
  });
});

after(async () => {
  await browser?.close();
  server?.close();
  screen?.kill();
});

async function open(address = "") {
  const page = await browser.newPage();
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(`exception: ${error.message}`));
  page.on("console", (message) => {
    if (["error", "warn"].includes(message.type())) complaints.push(message.text());
  });
  await page.setViewport({ width: 1280, height: 800 });
  await page.goto(server.url + address);
  await page.evaluate(() => evenlift.ready);
  await idle(page);
  page.done = async () => {
    assert.deepEqual(complaints, []);
    await page.close();
  };
  return page;
}

const state = (page) => page.evaluate(() => evenlift.state());

test("Firefox opens the page on its first sample and comes to rest", { skip }, async () => {
  const page = await open();
  const { teams, polygon } = await state(page);
  assert.equal(teams.length, 3);
  assert.ok(polygon.length > 10);
  const drawn = await page.evaluate(
    () =>
      new Promise((done) => {
        const { frames } = evenlift;
        let left = 30;
        const next = () => (--left > 0 ? requestAnimationFrame(next) : done(evenlift.frames - frames));
        next();
      }),
  );
  assert.equal(drawn, 0, "while the browser shows thirty pictures");
  await page.done();
});

test("Firefox draws a polygon by clicks", { skip }, async () => {
  const page = await open();
  await page.keyboard.press("d");
  for (const [x, y] of [
    [220, 200],
    [560, 190],
    [640, 420],
    [400, 610],
    [222, 202],
  ]) {
    await page.mouse.click(x, y);
    await idle(page);
  }
  assert.equal((await state(page)).polygon.length, 4);
  await page.done();
});

test("Firefox opens a link and keeps it in the address bar", { skip }, async () => {
  const link = "1.Pq1riQoPLvUJmF2ykWfnDSNVxm2W3yqqGl2Hz55vK9StSPd";
  const page = await open(`#${link}`);
  assert.equal(await page.evaluate(() => evenlift.link()), link);
  await page.evaluate(() => evenlift.set({ teams: 2 }));
  await idle(page);
  assert.equal(await page.evaluate(() => location.hash), `#${await page.evaluate(() => evenlift.link())}`);
  assert.notEqual(await page.evaluate(() => evenlift.link()), link);
  await page.done();
});

test("Firefox drags the centre of mass, and everything follows", { skip }, async () => {
  const page = await open();
  await page.evaluate(() => evenlift.load("(0,0)\n(40,0)\n(40,30)\n(0,30)"));
  await idle(page);
  const before = await state(page);
  const [x, y] = await page.evaluate((c) => evenlift.view.to_screen(...c), before.centre_of_mass);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y + 25, { steps: 6 });
  await page.mouse.up();
  await idle(page);
  const after = await state(page);
  assert.notDeepEqual(after.centre_of_mass, before.centre_of_mass);
  assert.notDeepEqual(after.teams, before.teams);
  await page.done();
});

test("Firefox shows the lesson: by keys, by its buttons, and from a link", { skip }, async () => {
  const page = await open();
  const summary = () => page.$eval("#summary", (element) => element.textContent);
  await page.evaluate(() => document.getElementById("canvas").focus());
  await page.keyboard.press("b");
  await idle(page);
  assert.match(await summary(), /^Step 1 of \d+, The object/);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("PageDown");
  await idle(page);
  const chapter = await summary();
  assert.doesNotMatch(chapter, /The object/);
  const at = await page.evaluate(() => evenlift.view.control("Next step"));
  await page.mouse.click(at.x + at.width / 2, at.y + at.height / 2);
  await idle(page);
  const next = await summary();
  const number = (text) => Number(/^Step (\d+) of/.exec(text)[1]);
  assert.equal(number(next), number(chapter) + 1);
  const link = await page.evaluate(() => evenlift.link());
  await page.done();
  const other = await open(`#${link}`);
  assert.equal(await other.$eval("#summary", (element) => element.textContent), next);
  await other.keyboard.press("q");
  await other.evaluate(() => document.getElementById("canvas").focus());
  await other.keyboard.press("End");
  await idle(other);
  assert.match(await other.$eval("#summary", (element) => element.textContent), /^Step (\d+) of \1,/);
  await other.done();
});

// Last, because the server ends.
test("Firefox opens the page without a network after one visit", { skip }, async () => {
  const page = await open();
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    if (!navigator.serviceWorker.controller)
      await new Promise((done) => navigator.serviceWorker.addEventListener("controllerchange", done, { once: true }));
  });
  await page.evaluate(() => evenlift.load("(0,0)\n(40,0)\n(40,30)\n(0,30)"));
  await idle(page);
  const before = await state(page);
  server.close();
  server = undefined;
  await reload(page);
  assert.deepEqual(await state(page), before);
  await page.evaluate(() => evenlift.set({ metric: "balanced", robots: 4 }));
  await idle(page);
  assert.equal((await state(page)).robots.length, 4);
  await page.close();
});
