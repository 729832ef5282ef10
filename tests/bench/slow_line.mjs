// node slow_line.mjs [FOLDER…]: what a visitor waits for on a line of 400 kbit/s, from a host that compresses, for each
// folder of a built page (else build/page). Everything is from the first visit on; the fastest of three.
import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { pageFolder, startBrowser, wide } from "../page/browser.mjs";

const bytesPerSecond = 400000 / 8;
const latency = 40; // milliseconds

const types = {
  ".css": "text/css",
  ".html": "text/html",
  ".js": "text/javascript",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

function serve(folder) {
  const packed = new Map();
  const server = createServer((request, response) => {
    const name = new URL(request.url, "http://localhost").pathname.slice(1) || "index.html";
    try {
      if (!packed.has(name)) packed.set(name, gzipSync(readFileSync(path.join(folder, name)), { level: 9 }));
    } catch {
      return response.writeHead(404).end();
    }
    const type = types[path.extname(name)] ?? "application/octet-stream";
    response.writeHead(200, { "Content-Type": type, "Content-Encoding": "gzip", "Cache-Control": "no-cache" });
    return response.end(packed.get(name));
  });
  return new Promise((done) => server.listen(0, "127.0.0.1", () => done(server)));
}

// A press on the cover, or D as soon as there is a picture. With `move`, the mouse moves until then.
async function visit(browser, address, { move = false } = {}) {
  const context = await browser.newContext({ viewport: wide, colorScheme: "light", reducedMotion: "reduce" });
  const page = await context.newPage();
  const session = await context.newCDPSession(page);
  await session.send("Network.enable");
  await session.send("Network.emulateNetworkConditions", {
    offline: false,
    latency,
    downloadThroughput: bytesPerSecond,
    uploadThroughput: bytesPerSecond,
  });
  await page.addInitScript(() => {
    const now = () => performance.now();
    globalThis.seen = {};
    const waiting = setInterval(() => {
      const { seen } = globalThis;
      if (document.querySelector("#cover.done")) seen.picture ??= now();
      const drawing = document.getElementById("summary")?.textContent.startsWith("Draw a shape");
      if (drawing) {
        seen.answer ??= now();
        clearInterval(waiting);
      }
    }, 5);
  });
  await page.goto(address, { waitUntil: "commit" });
  if (move) {
    const moving = setInterval(() => page.mouse.move(300 + 400 * Math.random(), 300).catch(() => {}), 200);
    await page.waitForFunction(() => globalThis.seen.picture, undefined, { timeout: 0, polling: 50 });
    clearInterval(moving);
  } else if (await page.locator("#first").count()) {
    await page.getByRole("button", { name: "Draw your own" }).click({ timeout: 120000 });
  } else {
    await page.waitForFunction(() => globalThis.seen.picture, undefined, { timeout: 0, polling: 50 });
  }
  // The first thing that can be pressed: the cover's card, or D once there is a picture.
  if (move || !(await page.evaluate(() => globalThis.seen.answer || document.querySelector("#first .pressed"))))
    await page.keyboard.press("d");
  await page.waitForFunction(() => globalThis.seen.answer, undefined, { timeout: 0, polling: 50 });
  const result = await page.evaluate(() => ({
    paint: performance.getEntriesByName("first-contentful-paint")[0]?.startTime,
    ...globalThis.seen,
  }));
  await context.close();
  return result;
}

const { browser, close } = await startBrowser([], { drawn: true });
for (const folder of process.argv.length > 2 ? process.argv.slice(2) : [pageFolder]) {
  const server = await serve(folder);
  const address = `http://127.0.0.1:${server.address().port}/`;
  for (const move of [false, true]) {
    const all = [];
    for (let i = 0; i < 3; ++i) all.push(await visit(browser, address, { move }));
    const best = (name) => (Math.min(...all.map((one) => one[name])) / 1000).toFixed(2);
    console.log(
      `${folder}${move ? ", the mouse moves" : ""}: first paint ${best("paint")} s, first picture ${best("picture")} s, first press answered ${best("answer")} s`,
    );
  }
  server.close();
}
await close();
