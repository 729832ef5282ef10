// A browser with the built page, for the tests.
//   EVENLIFT_PAGE     the page's folder, else build/page
//   EVENLIFT_BROWSER  Chromium or Chrome, else /usr/bin/chromium-headless-shell or /usr/bin/chromium
//   EVENLIFT_PROGRAM  the native program, else build/bin/evenlift
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { after, before } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "../../web/serve.mjs";

export const root = fileURLToPath(new URL("../..", import.meta.url));
export const pageFolder = process.env.EVENLIFT_PAGE || path.join(root, "build/page");
const executed = process.env.EVENLIFT_PROGRAM || path.join(root, "build/bin/evenlift");

// Headless Chromium alone opens a page three times as fast.
const executable =
  process.env.EVENLIFT_BROWSER ||
  ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"].find((file) => existsSync(file));

// axe-core as a script for the page, and a reader of QR codes.
export const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
export { default as jsQR } from "jsqr";

// WebGL without graphics hardware: Mesa's if installed, which draws twice as fast, or Chromium's own.
const graphics = existsSync("/usr/share/glvnd/egl_vendor.d/50_mesa.json")
  ? ["--use-angle=gl-egl", "--ignore-gpu-blocklist"]
  : ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

// A browser that need not paint WebGL takes a tenth less processor time without a graphics process.
const noGraphics = ["--disable-gpu"];

// No network requests of its own; WebAssembly is optimised late, as most tests are too short to repay it.
const options = [
  "--js-flags=--wasm-tiering-budget=200000000",
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

// How long to wait for an expected event: enough for a very busy machine.
export const patience = 300000;

export const wide = { width: 1280, height: 800 };
export const phone = { width: 390, height: 844 };

export function evenlift(...args) {
  return execFileSync(executed, args, { encoding: "utf8", maxBuffer: 1 << 28 });
}

// A sample's file, its contents, and the program's placement of it.
export const sample = (name) => path.join(root, "assets/polygons", `${name}.txt`);
export const asset = (name) => readFileSync(sample(name), "utf8");
export const program = (name, ...options) =>
  JSON.parse(evenlift("place", sample(name), "--json", "--candidates", ...options));

export const lShape = "(0,0)\n(400,0)\n(400,150)\n(150,150)\n(150,300)\n(0,300)\n";

// In the gallery's order.
export function gallery() {
  return readFileSync(path.join(root, "assets/polygons/index.txt"), "utf8")
    .split("\n")
    .filter((line) => line && !line.startsWith("#"))
    .map((line) => line.split(/\s+/)[0]);
}

// Serves the page and starts a browser, and another one when `drawn` first asks for painting; close() ends all.
export async function startBrowser(extraOptions = [], { drawn: always = false } = {}) {
  const server = await serve(pageFolder, 0);
  const launch = (chosen) =>
    chromium.launch({ executablePath: executable, args: [...options, ...chosen, ...extraOptions] });
  const browser = await launch(always ? graphics : noGraphics);
  let painting = always ? browser : undefined;
  async function close() {
    await browser.close();
    if (painting && painting !== browser) await painting.close();
    server.close();
  }

  // A page with its own storage. Complaints of the page and requests to other hosts fail the test at close(). Only
  // `drawn` paints the canvas, for tests of its pixels and of WebGL: without graphics hardware, painting takes a third
  // of a test's time. With `hasty`, a test can fire the page's timers early; `first` shows the first visit's card. With
  // `offline`, the browser may keep the page for later; `site` is another server's address.
  async function open({
    address = "",
    ready = true,
    quiet = true,
    context: reused,
    script,
    drawn = always,
    hasty = false,
    first = false,
    offline = false,
    site = server.url,
    ...contextOptions
  } = {}) {
    // A test need not wait for motion.
    const usual = { viewport: wide, colorScheme: "light", reducedMotion: "reduce" };
    if (drawn && !reused) painting ??= await launch(graphics);
    const chosen = drawn ? painting : browser;
    const context = reused ?? (await chosen.newContext({ ...usual, ...contextOptions }));
    context.setDefaultTimeout(patience);
    const page = await context.newPage();
    if (!drawn) await paintNothing(page);
    if (hasty) await page.addInitScript(keepTimers);
    const complaints = [];
    page.on("pageerror", (error) => complaints.push(`exception: ${error.message}`));
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
    });
    page.on("request", (request) => {
      const { protocol, origin } = new URL(request.url());
      const own = origin === new URL(site).origin || ["data:", "blob:"].includes(protocol);
      if (!own) complaints.push(`a request to ${request.url()}`);
    });
    await page.addInitScript(() => {
      addEventListener("securitypolicyviolation", (event) => console.error(`policy: ${event.violatedDirective}`));
    });
    if (!first) {
      await page.addInitScript(() => {
        if (location.protocol.startsWith("http")) localStorage.setItem("evenlift.welcomed", "1");
      });
    }
    if (!offline) await page.addInitScript(keepNothing);
    if (script) await page.addInitScript(script);
    await page.goto(site + address);
    // The controls in HTML come after the first picture.
    if (ready) await page.evaluate(() => evenlift.idle());
    page.complaints = complaints;
    page.done = async () => {
      if (quiet) assert.deepEqual(complaints, []);
      if (!reused) await context.close();
      else await page.close();
    };
    return page;
  }

  // The share of pixels that differ visibly between two PNGs of one size: by more than anti-aliasing in some channel,
  // from every neighbour.
  async function compare(a, b) {
    const page = await browser.newPage();
    try {
      return await page.evaluate(comparePictures, [a.toString("base64"), b.toString("base64")]);
    } finally {
      await page.close();
    }
  }
  return { browser, server, open, compare, close };
}

// For all tests of a file: starts before them and runs `begin`, then runs `end` and closes. `drawn` paints the canvas.
export function sharedBrowser({ begin = () => {}, end = () => {}, drawn = false } = {}) {
  const shared = {};
  before(async () => {
    Object.assign(shared, await startBrowser([], { drawn }));
    await begin();
  });
  after(async () => {
    try {
      await end();
    } finally {
      await shared.close();
    }
  });
  return shared;
}

// The page's WebGL accepts every command and does nothing.
async function paintNothing(page) {
  await page.addInitScript(drawNowhere);
  page.screenshot = () => assert.fail("this page paints nothing: open it with `drawn`");
}

// Runs before the page's own scripts.
function drawNowhere() {
  const { prototype } = globalThis.WebGL2RenderingContext ?? {};
  if (!prototype) return;
  const answers = {
    getError: () => 0,
    getExtension: () => null,
    getParameter: (name) => ({ 0x1f02: "WebGL 2.0", 0x8b8c: "WebGL GLSL ES 3.00" })[name] ?? 4096,
    getProgramParameter: () => 1,
    getShaderParameter: () => 1,
    getSupportedExtensions: () => [],
    isContextLost: () => false,
  };
  for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(prototype))) {
    if (typeof value !== "function" || name === "constructor") continue;
    prototype[name] = answers[name] ?? (() => (/^(create|get)/.test(name) ? {} : undefined));
  }
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
    if (kind !== "webgl2") return getContext.call(this, kind, ...options);
    return Object.create(prototype, {
      canvas: { value: this },
      drawingBufferWidth: { get: () => this.width },
      drawingBufferHeight: { get: () => this.height },
    });
  };
}

// Runs in a browser, which decodes PNG.
async function comparePictures([first, second]) {
  const pixels = async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height);
  };
  const a = await pixels(first);
  const b = await pixels(second);
  if (a.width !== b.width || a.height !== b.height) return { share: 1, size: [a.width, a.height, b.width, b.height] };
  const near = (x, y) => {
    const at = 4 * (y * a.width + x);
    for (let dy = -1; dy <= 1; ++dy) {
      for (let dx = -1; dx <= 1; ++dx) {
        const other =
          4 * (Math.min(Math.max(y + dy, 0), a.height - 1) * a.width + Math.min(Math.max(x + dx, 0), a.width - 1));
        if ([0, 1, 2].every((c) => Math.abs(a.data[at + c] - b.data[other + c]) <= 24)) return true;
      }
    }
    return false;
  };
  let different = 0;
  for (let y = 0; y < a.height; ++y) {
    for (let x = 0; x < a.width; ++x) if (!near(x, y)) ++different;
  }
  return { share: different / (a.width * a.height), size: [a.width, a.height] };
}

// --- In the page -----------------------------------------------------------------------------------------------------

export const state = (page) => page.evaluate(() => evenlift.state());
export const load = (page, text) => page.evaluate((t) => evenlift.load(t), text);
export const set = (page, changes) => page.evaluate((c) => evenlift.set(c), changes);
export const link = (page) => page.evaluate(() => evenlift.link());
export const fragment = (page) => page.evaluate(() => location.hash.slice(1));
export const toScreen = (page, [x, y]) => page.evaluate((p) => evenlift.view.to_screen(...p), [x, y]);

// The message of the error that a call throws in the page, or undefined.
export function thrown(page, call, argument) {
  return page.evaluate(
    ([name, value]) => {
      try {
        evenlift[name](value);
      } catch (error) {
        return error instanceof Error ? error.message : `not an Error: ${error}`;
      }
    },
    [call, argument],
  );
}

// The text for screen readers about drawing and result.
export const summary = (page) => page.locator("#summary").textContent();

// Resolves once nothing is under way in the page (docs/page.md): tests wait for this, not for a time.
export const idle = (page) => page.evaluate(() => evenlift.idle());

// The controls that are in the panel's drawers (wasm/panels/drawers.cpp).
const drawers = {
  Object: ["com", "com radius", "com height", "length units", "weight units", "Add cargo", "Add a hole"],
  Robots: [
    ...["capacity", "use needed", "any", "ratio", "min ratio", "seed", "goals", "min margin", "survive", "radius"],
    ...["robot radius", "robot reach", "robot depth", "robot width", "robot gap", "no go", "mark edges", "accuracy"],
    ...["clear", "positions", "apart", "snap"],
  ],
  Carrying: ["slope", "acceleration", "dynamic", "weight doubt", "uneven", "give", "extra", "cases"],
  Weighing: ["reading_error", "level_error", "tilted", "heading", "readings_tilted"],
  Show: [
    "Base",
    "Chords",
    "Candidates",
    "Clockwise",
    "Counter-clockwise",
    "Tipping",
    "Tipping distance",
    "Tilt",
    "loads",
  ],
  Compare: ["compared"],
};
const drawerOf = (name) => Object.keys(drawers).find((drawer) => drawers[drawer].includes(name.replace(/ [-+]$/, "")));

const place = async (page, name) => {
  await idle(page);
  return page.evaluate((n) => evenlift.view.control(n), name);
};

// Opens drawers of the panel, as screen readers do, by their names for scripts.
export async function openDrawers(page, ...names) {
  for (const name of names) {
    const head = await place(page, name);
    if (!head) continue;
    await page.$$eval(
      "#mirror button[aria-pressed]",
      (buttons, { x, y }) => {
        const isHead = (button) => {
          const box = button.getBoundingClientRect();
          return Math.abs(box.x - x) < 1 && Math.abs(box.y - y) < 1;
        };
        const button = buttons.find(isHead);
        if (button?.ariaPressed === "false") button.click();
      },
      head,
    );
    await idle(page);
  }
}

// Scrolls the side panel until the control is in sight, like a wheel.
async function inSight(page, name, found) {
  const { width, height } = page.viewportSize();
  const verdict = await place(page, "failures");
  if (!found || !verdict || width < 640 || found.x < width - 400 || found.x < verdict.x - 8) return found;
  const y = found.y + found.height / 2;
  const stays = ["failures", "failure +", "failure -", "offer", "whole verdict", "fold"].includes(name);
  if (stays || (y < height - 40 && y > verdict.y + verdict.height + 48)) return found;
  await page.mouse.move(found.x + 4, height - 60);
  await page.mouse.wheel(0, y - 0.65 * height);
  return place(page, name);
}

// The place and middle of a control of the canvas; null if it is not shown, in a drawer either.
export async function controlIfShown(page, name) {
  let found = await place(page, name);
  const drawer = drawerOf(name);
  if (!found && drawer) {
    await openDrawers(page, drawer);
    found = await place(page, name);
  }
  if (drawer) found = await inSight(page, name, found);
  return found && { ...found, middle: [found.x + found.width / 2, found.y + found.height / 2] };
}

export async function control(page, name) {
  const place = await controlIfShown(page, name);
  assert.ok(place, `there is no control “${name}”`);
  return place;
}

export async function press(page, name) {
  const { x, y, width, height } = await inSight(page, name, await control(page, name));
  const middle = [x + width / 2, y + height / 2];
  await page.mouse.click(...middle);
}

// Types over a field of the panel as users do, with Enter at the end.
export async function type(page, name, text) {
  await press(page, name);
  await page.keyboard.type(text);
  await page.keyboard.press("Enter");
  await idle(page);
}

export async function tap(page, name) {
  const { middle } = await control(page, name);
  await page.touchscreen.tap(...middle);
}

// Runs before the page's own scripts: evenliftTimersRing() fires all timers at once.
function keepTimers() {
  const { setTimeout: begin, clearTimeout: end } = globalThis;
  const kept = new Map();
  const ring = (id) => {
    const call = kept.get(id);
    kept.delete(id);
    call();
  };
  globalThis.setTimeout = (callback, time, ...given) => {
    const id = begin(() => ring(id), time);
    kept.set(id, () => callback(...given));
    return id;
  };
  globalThis.clearTimeout = (id) => {
    kept.delete(id);
    end(id);
  };
  globalThis.evenliftTimersRing = () => {
    for (const id of [...kept.keys()]) {
      end(id);
      ring(id);
    }
  };
}

// Checks that nothing is drawn, however long the wait: all timers fire, and the browser draws frames. Needs `hasty`.
export async function drawsNothing(page, why) {
  await idle(page);
  const [before, after] = await page.evaluate(async () => {
    const { frames } = evenlift;
    evenliftTimersRing();
    for (let i = 0; i < 10; ++i) await new Promise((done) => requestAnimationFrame(done));
    return [frames, evenlift.frames];
  });
  assert.equal(after, before, why);
}

// Runs before the page's own scripts: some browsers keep no page for later in private windows.
function keepNothing() {
  if (globalThis.ServiceWorkerContainer)
    ServiceWorkerContainer.prototype.register = () => Promise.reject(new Error("not here"));
}

// Presses at one point and moves in steps to another, like a hand.
export async function drag(page, from, to, steps = 8) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps });
  await page.mouse.up();
  await idle(page);
}

// Waits until the page is idle again.
export async function reload(page) {
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  await idle(page);
}

// An idle page with the L.
export async function openL(browser, options) {
  const page = await browser.open(options);
  await load(page, lShape);
  await idle(page);
  return page;
}

export async function undo(page) {
  await page.keyboard.press("Control+z");
  await idle(page);
}
export async function redo(page) {
  await page.keyboard.press("Control+Shift+Z");
  await idle(page);
}

// Waits until the address bar has the current link.
export async function published(page) {
  await page.waitForFunction(() => location.hash === `#${evenlift.link()}`);
}
