// node page.mjs: what the page weighs, how soon its first picture is there, and how long a frame takes while a polygon
// of 1,000 vertices is dragged. The settings of tests/page/browser.mjs.
import { load, settled, startBrowser, state, toScreen } from "../page/browser.mjs";
import { sizes } from "../page/sizes.mjs";

const line = (name, value) => console.log(name.padEnd(62), value.padStart(16));

const { files, start, all } = sizes();
for (const { name, bytes } of files) line(name, `${bytes} bytes`);
line("before the first picture, gzip -9", `${start} bytes`);
line("with what is loaded when it is asked for", `${all} bytes`);

const browser = await startBrowser();

const starts = [];
for (let i = 0; i < 7; ++i) {
  const page = await browser.open({
    script: () => {
      const known = setInterval(() => {
        if (!globalThis.evenlift) return;
        clearInterval(known);
        evenlift.ready.then(() => { globalThis.readyAt = performance.now(); });
      }, 1);
    },
  });
  starts.push(await page.evaluate(() => globalThis.readyAt));
  await page.done();
}
line("first picture, fastest of 7", `${Math.min(...starts).toFixed(0)} ms`);

// The page's own work in a frame; what the browser does with the picture afterwards is not in it.
function timeFrames() {
  const own = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.frameTimes = [];
  globalThis.requestAnimationFrame = (callback) => own((now) => {
    const start = performance.now();
    callback(now);
    globalThis.frameTimes.push(performance.now() - start);
  });
}

const circle = (n) => Array.from({ length: n }, (_, i) => {
  const a = (2 * Math.PI * i) / n;
  const r = 300 + 60 * Math.sin(7 * a) + 20 * Math.sin(31 * a);
  return `(${(r * Math.cos(a)).toFixed(2)},${(r * Math.sin(a)).toFixed(2)})`;
}).join("\n");

for (const n of [100, 1000]) {
  const page = await browser.open({ script: timeFrames });
  await load(page, circle(n));
  await settled(page);
  const [x, y] = await toScreen(page, (await state(page)).centre_of_mass);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.evaluate(() => { globalThis.frameTimes.length = 0; });
  for (let i = 1; i <= 60; ++i) await page.mouse.move(x + i, y + i / 2);
  const times = (await page.evaluate(() => globalThis.frameTimes)).filter((time) => time > 0.5).sort((a, b) => a - b);
  await page.mouse.up();
  await page.done();
  const at = (share) => times[Math.floor(share * (times.length - 1))].toFixed(1);
  line(`a frame of dragging, ${n} vertices: median, 95 % (${times.length} frames)`, `${at(0.5)}, ${at(0.95)} ms`);
}
await browser.close();
