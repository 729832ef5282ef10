// node page.mjs: the sizes of the page's files, the time to its first frame, and frame times while C or a robot is
// dragged with 1,000 vertices. Settings are those of tests/page/browser.mjs, but WebAssembly is optimised as early as
// usual.
import { load, idle, startBrowser, state, toScreen } from "../page/browser.mjs";
import { coast } from "../shapes/coast.mjs";
import { loaded, sizes, total } from "../page/sizes.mjs";

const line = (name, value) => console.log(name.padEnd(62), value.padStart(16));

for (const { name, bytes } of sizes()) line(name, `${bytes} bytes`);
line("with what is loaded when it is asked for", `${total(sizes())} bytes`);

const browser = await startBrowser(["--js-flags="], { drawn: true });
const opened = await browser.open();
line("until the page is ready, gzip -9", `${total(await loaded(opened))} bytes`);
await opened.done();

// The first picture, and the whole program with its controls.
const starts = { picture: [], ready: [] };
for (let i = 0; i < 7; ++i) {
  const page = await browser.open({
    script: () => {
      const waiting = setInterval(() => {
        if (!document.querySelector("#cover.done")) return;
        clearInterval(waiting);
        globalThis.pictureAt = performance.now();
        evenlift.ready.then(() => {
          globalThis.readyAt = performance.now();
        });
      }, 1);
    },
  });
  starts.picture.push(await page.evaluate(() => globalThis.pictureAt));
  starts.ready.push(await page.evaluate(() => globalThis.readyAt));
  await page.done();
}
line("first picture, fastest of 7", `${Math.min(...starts.picture).toFixed(0)} ms`);
line("the whole page, fastest of 7", `${Math.min(...starts.ready).toFixed(0)} ms`);

// The page's own work in a frame, without the browser's afterwards.
function timeFrames() {
  const own = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.frameTimes = [];
  globalThis.requestAnimationFrame = (callback) =>
    own((now) => {
      const start = performance.now();
      callback(now);
      globalThis.frameTimes.push(performance.now() - start);
    });
}

const circle = (n) =>
  Array.from({ length: n }, (_, i) => {
    const a = (2 * Math.PI * i) / n;
    const r = 300 + 60 * Math.sin(7 * a) + 20 * Math.sin(31 * a);
    return `(${(r * Math.cos(a)).toFixed(2)},${(r * Math.sin(a)).toFixed(2)})`;
  }).join("\n");

// Drags by 60 pixels, and reports the frame times.
async function dragFrames(page, [x, y], name) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.evaluate(() => {
    globalThis.frameTimes.length = 0;
  });
  for (let i = 1; i <= 60; ++i) await page.mouse.move(x + i, y + i / 2);
  const times = (await page.evaluate(() => globalThis.frameTimes)).filter((time) => time > 0.5).sort((a, b) => a - b);
  await page.mouse.up();
  await page.done();
  const at = (share) => times[Math.floor(share * (times.length - 1))].toFixed(1);
  line(`${name}: median, 95 % (${times.length} frames)`, `${at(0.5)}, ${at(0.95)} ms`);
}

for (const n of [100, 1000]) {
  const page = await browser.open({ script: timeFrames });
  await load(page, circle(n));
  await idle(page);
  await dragFrames(page, await toScreen(page, (await state(page)).centre_of_mass), `dragging C, ${n} vertices`);
}

// Robots placed by hand, half at vertices and half beneath the object.
for (const [n, robots] of [
  [100, 6],
  [1000, 64],
]) {
  const page = await browser.open({ script: timeFrames });
  await load(page, circle(n));
  await page.evaluate((count) => {
    const { polygon } = evenlift.state();
    const places = Array.from({ length: count }, (_, i) => {
      const vertex = polygon[Math.floor((i * polygon.length) / count)];
      return i % 2 ? vertex : vertex.map((value) => value / 2);
    });
    evenlift.set({ supports: places });
  }, robots);
  await idle(page);
  const { robots: placed } = await state(page);
  await dragFrames(page, await toScreen(page, placed[2].at), `dragging one of ${robots} robots by hand, ${n} vertices`);
}

// How long the page is blocked while a vertex or C of a large polygon is dragged: the longest task, the median from 5
// ms on, and the number longer than a frame. All in processor time, which other jobs affect less.
for (const [name, spot] of [
  ["a vertex", ({ polygon }) => polygon[5000]],
  ["C", ({ centre_of_mass: centre }) => centre],
]) {
  const page = await browser.open();
  await load(page, coast(20034));
  await page.evaluate(() => evenlift.set({ teams: 10 }));
  await idle(page);
  const [x, y] = await toScreen(page, spot(await state(page)));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await idle(page);
  await browser.browser.startTracing(page, {
    categories: ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline"],
  });
  for (let i = 1; i <= 60; ++i) await page.mouse.move(x + i, y + i / 2);
  const { traceEvents: events } = JSON.parse((await browser.browser.stopTracing()).toString());
  await page.mouse.up();
  await page.done();
  // Of the renderers' tasks, those in which the page drew.
  const drew = events.find(({ name: of }) => of === "FireAnimationFrame");
  const times = events
    .filter(({ name: of, pid, tid, tdur }) => of === "RunTask" && pid === drew.pid && tid === drew.tid && tdur > 5000)
    .map(({ tdur }) => tdur / 1000)
    .sort((a, b) => a - b);
  line(
    `a coast of 20,034 vertices, ten teams: a task of dragging ${name}, middle, longest`,
    `${times[times.length >> 1].toFixed(0)}, ${times.at(-1).toFixed(0)} ms`,
  );
  line("  tasks from 5 ms on, and longer than a frame", `${times.length}, ${times.filter((t) => t > 16.7).length}`);
}

// One case of each limit in README.md: the time until all of it is on screen, and the frame time afterwards.
const star = (n) =>
  Array.from({ length: n }, (_, i) => {
    const a = (2 * Math.PI * i) / n;
    const r = 4e5 + 5e4 * Math.sin(9 * a);
    return `(${(r * Math.cos(a)).toFixed(2)},${(r * Math.sin(a)).toFixed(2)})`;
  }).join("\n");
// A comb with the most edge pairs permitted, or nearly so.
const comb = (teeth) =>
  `${Array.from({ length: teeth }, (_, i) => `(${2 * i},0)\n(${2 * i},${teeth})\n(${2 * i + 1},${teeth})\n(${2 * i + 1},0)`).join("\n")}\n(${2 * teeth - 1},-1)\n(0,-1)`;

async function limit(name, text, settings = {}) {
  for (const deviceScaleFactor of [1, 3]) {
    const page = await browser.open({ script: timeFrames, deviceScaleFactor, quiet: false });
    try {
      await page.waitForFunction(() => evenlift.frames > 0);
      const ms = await page.evaluate(
        async ([given, changes]) => {
          const start = performance.now();
          evenlift.load(given);
          evenlift.set(changes);
          await evenlift.idle();
          return performance.now() - start;
        },
        [text, settings],
      );
      await page.evaluate(() => {
        globalThis.frameTimes.length = 0;
      });
      for (let i = 0; i < 5; ++i) {
        await page.mouse.move(400 + 10 * i, 400);
        await idle(page);
      }
      const times = (await page.evaluate(() => globalThis.frameTimes))
        .filter((time) => time > 0.5)
        .sort((a, b) => a - b);
      line(
        `${name}, ratio ${deviceScaleFactor}: opened; a frame, median`,
        `${ms.toFixed(0)}, ${times[times.length >> 1]?.toFixed(0)} ms`,
      );
    } catch (error) {
      line(`${name}, ratio ${deviceScaleFactor}`, error.message.split("\n")[0]);
    }
    await page.done();
  }
}

await limit("32,768 vertices, the largest link", star(32768));
await limit("1,048,576 vertices", star(1048576));
await limit("a comb of 5,002 vertices", comb(1250));
await limit("1,048,576 random teams", star(8), { metric: "random", teams: 1048576 });
await browser.close();
