// The page in Firefox, through WebDriver BiDi: opening, drawing, link and drag. Firefox has WebGL only where there is a
// screen: without one, Xvfb stands in.
//   EVENLIFT_FIREFOX  Firefox; without it, these tests are skipped
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { after, before, test } from "node:test";
import puppeteer from "puppeteer-core";
import { serve } from "../../web/serve.mjs";
import { pageFolder, settled } from "./browser.mjs";

const executablePath = process.env.EVENLIFT_FIREFOX;
const skip = executablePath ? false : "no Firefox here";

let screen;
let server;
let browser;

// A display of its own, whatever numbers are taken: Xvfb chooses one and tells it.
async function startScreen() {
  screen = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", "1400x1000x24", "-nolisten", "tcp"],
    { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  const failed = once(screen, "error").then(([error]) => {
    throw error;
  });
  const [number] = await Promise.race([once(screen.stdio[3], "data"), failed]);
  return `:${String(number).trim()}`;
}

before(async () => {
  if (skip) return;
  server = await serve(pageFolder, 0);
  const DISPLAY = process.env.DISPLAY || await startScreen();
  browser = await puppeteer.launch({
    browser: "firefox", executablePath, headless: false, env: { ...process.env, DISPLAY },
    // A machine without graphics draws in software, which Firefox would rather not.
    extraPrefsFirefox: { "webgl.force-enabled": true, "widget.dmabuf.force-enabled": false },
  });
}, { timeout: 120000 });

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
  page.waitForTimeout = (time) => new Promise((done) => setTimeout(done, time));
  await settled(page);
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
  const frames = await page.evaluate(() => evenlift.frames);
  await page.waitForTimeout(500);
  assert.equal(await page.evaluate(() => evenlift.frames), frames);
  await page.done();
});

test("Firefox draws a polygon by clicks", { skip }, async () => {
  const page = await open();
  await page.keyboard.press("d");
  for (const [x, y] of [[220, 200], [560, 190], [640, 420], [400, 610], [222, 202]]) {
    await page.mouse.click(x, y);
    await settled(page, 50);
  }
  assert.equal((await state(page)).polygon.length, 4);
  await page.done();
});

test("Firefox opens a link and keeps it in the address bar", { skip }, async () => {
  const link = "1.Pq1riQoPLvUJmF2ykWfnDSNVxm2W3yqqGl2Hz55vK9StSPd";
  const page = await open(`#${link}`);
  assert.equal(await page.evaluate(() => evenlift.link()), link);
  await page.evaluate(() => evenlift.set({ teams: 2 }));
  await page.waitForFunction(() => location.hash === `#${evenlift.link()}`);
  assert.notEqual(await page.evaluate(() => evenlift.link()), link);
  await page.done();
});

test("Firefox drags the centre of mass, and everything follows", { skip }, async () => {
  const page = await open();
  const before = await state(page);
  const [x, y] = await page.evaluate((c) => evenlift.view.to_screen(...c), before.centre_of_mass);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y + 25, { steps: 6 });
  await page.mouse.up();
  await settled(page);
  const after = await state(page);
  assert.notDeepEqual(after.centre_of_mass, before.centre_of_mass);
  assert.notDeepEqual(after.teams, before.teams);
  await page.done();
});
