// Sharpness, size, colours, failure: what the page does on all kinds of screens and without one.
import assert from "node:assert/strict";
import { test } from "node:test";
import { idle, load, phone, press, sharedBrowser, startBrowser, state, thrown, wide } from "./browser.mjs";
import { sizes } from "./sizes.mjs";

const browser = sharedBrowser();

const canvasSize = (page) => page.evaluate(() => {
  const canvas = document.getElementById("canvas");
  return [canvas.width, canvas.height];
});

for (const ratio of [1, 1.5, 2, 3]) {
  test(`${ratio} device pixels for a CSS pixel: the canvas has them all`, async () => {
    const page = await browser.open({ deviceScaleFactor: ratio });
    assert.deepEqual(await canvasSize(page), [wide.width * ratio, wide.height * ratio]);
    await page.done();
  });
}

test("it follows the window's size and a change of the device-pixel ratio", async () => {
  const page = await browser.open();
  await page.setViewportSize({ width: 1000, height: 700 });
  await idle(page);
  assert.deepEqual(await canvasSize(page), [1000, 700]);
  const client = await page.context().newCDPSession(page);
  await client.send("Emulation.setDeviceMetricsOverride", { width: 1000, height: 700, deviceScaleFactor: 2, mobile: false });
  await page.mouse.move(500, 300);  // this emulation tells nobody; on a real screen the browser does
  await page.waitForFunction(() => document.getElementById("canvas").width === 2000);
  await idle(page);
  assert.deepEqual(await canvasSize(page), [2000, 1400]);
  await page.done();
});

test("the object stays in sight when the window changes, and everything is within it on a phone", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  await idle(page);
  const seen = () => page.evaluate(() => evenlift.state().polygon.every((p) => {
    const [x, y] = evenlift.view.to_screen(...p);
    return x >= 0 && x <= innerWidth && y >= 0 && y <= innerHeight;
  }));
  assert.ok(await seen());
  await page.setViewportSize({ width: phone.height, height: phone.width });
  await idle(page);
  assert.ok(await seen());
  await page.done();
});

test("light and dark follow the system while the page runs", async () => {
  const page = await browser.open();
  await idle(page);
  const bright = await lightness(page);
  await page.emulateMedia({ colorScheme: "dark" });
  await idle(page);
  const dark = await lightness(page);
  assert.ok(bright > 0.8 && dark < 0.25, `${bright} and ${dark}`);
  await page.done();
});

// Of the ground, in a corner where nothing stands.
async function lightness(page) {
  const other = await browser.browser.newPage();
  const png = (await page.screenshot({ clip: { x: 4, y: 300, width: 8, height: 8 } })).toString("base64");
  const value = await other.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const context = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d");
    context.drawImage(image, 0, 0, 1, 1);
    const [r, g, b] = context.getImageData(0, 0, 1, 1).data;
    return (r + g + b) / 765;
  }, png);
  await other.close();
  return value;
}

test("a lost WebGL context comes back with everything on it", async () => {
  const page = await browser.open();
  await idle(page);
  const before = await page.screenshot();
  await page.evaluate(() => {
    globalThis.extension = document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context");
    globalThis.extension.loseContext();
  });
  await page.waitForFunction(() => !document.getElementById("cover").classList.contains("done"));
  await page.evaluate(() => evenlift.set({ teams: 3 }));  // the program goes on without a canvas
  await page.evaluate(() => globalThis.extension.restoreContext());
  await page.waitForFunction(() => document.getElementById("cover").classList.contains("done"));
  await idle(page);
  const { share } = await browser.compare(before, await page.screenshot());
  assert.ok(share < 0.001, `${share} of the picture differs`);
  await page.done();
});

test("without WebGL 2 it says so, and ready is rejected with the reason", async () => {
  const page = await browser.open({
    ready: false, quiet: false,
    script: () => { HTMLCanvasElement.prototype.getContext = () => null; },
  });
  const reason = await page.evaluate(() => evenlift.ready.then(() => "ready", (error) => error.message));
  assert.match(reason, /WebGL 2/);
  assert.match(await page.locator("#problem").textContent(), /WebGL 2/);
  assert.ok(await page.locator("#problem").isVisible());
  assert.match(await thrown(page, "link"), /not ready|cannot run/);
  assert.deepEqual(page.complaints, []);
  await page.done();
});

test("without WebAssembly it says so", async () => {
  const page = await browser.open({ ready: false, quiet: false, script: () => { delete globalThis.WebAssembly; } });
  assert.match(await page.evaluate(() => evenlift.ready.then(() => "ready", (error) => error.message)), /WebAssembly/);
  assert.ok(await page.locator("#problem").isVisible());
  await page.done();
});

test("without graphics at all it says so", async (t) => {
  const bare = await startBrowser(["--disable-gpu", "--disable-3d-apis"]);
  t.after(() => bare.close());
  const page = await bare.open({ ready: false, quiet: false });
  assert.match(await page.evaluate(() => evenlift.ready.then(() => "ready", (error) => error.message)), /WebGL 2/);
  await page.done();
});

test("without JavaScript there is a word about it", async () => {
  const page = await browser.open({ ready: false, javaScriptEnabled: false });
  assert.match(await page.locator("body").textContent(), /JavaScript/);
  await page.done();
});

test("it runs in a sub-folder of a static host, under its policy", async () => {
  const response = await fetch(browser.server.url);
  assert.equal(response.headers.get("content-security-policy"),
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:");
  const html = await response.text();
  assert.doesNotMatch(html, /(?:src|href)="(?:\/|https?:)/, "only relative addresses");
  assert.doesNotMatch(html, /<script(?![^>]*src)|<style|\son\w+=|style="/, "nothing inline");
});

test("it has nothing in the console from start to end of a session", async () => {
  const page = await browser.open();
  await load(page, "(0,0)\n(10,0)\n(10,10)\n(0,10)");
  await page.mouse.move(500, 400);
  await page.mouse.wheel(0, 200);
  await idle(page);
  assert.equal((await state(page)).polygon.length, 4);
  await page.done();
});

test("embedded it shows the drawing and a link out, and no panel", async () => {
  const page = await browser.open({ address: "?embed=1", viewport: { width: 640, height: 420 } });
  await idle(page);
  const seen = await page.evaluate(() => evenlift.state().polygon.every((p) => {
    const [x, y] = evenlift.view.to_screen(...p);
    return x >= 0 && x <= innerWidth && y >= 0 && y <= innerHeight;
  }));
  assert.ok(seen);
  const [popup] = await Promise.all([page.waitForEvent("popup"), press(page, "out")]);
  await popup.waitForLoadState();
  const url = new URL(popup.url());
  assert.equal(url.search, "");
  await page.done();
});

test("what the first picture and all tools need is at most 580,000 bytes after compression", () => {
  const { start } = sizes();
  assert.ok(start <= 580000, `${start} bytes after gzip`);
});
