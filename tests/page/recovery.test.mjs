// Whatever fails while opening or drawing, the last good document comes back with a message, and a failed start is not
// repeated.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import {
  asset,
  evenlift,
  idle,
  link,
  load,
  published,
  set,
  sharedBrowser,
  state,
  thrown,
  toScreen,
  wide,
} from "./browser.mjs";
import { noticed, openWindow } from "./windows.mjs";

const browser = sharedBrowser();

// --- The documented limits -------------------------------------------------------------------------------------------

// A smooth outline of n vertices, made in the page. A more symmetric one has many teams of nearly equal score, whose
// placement would take longer than the drawing.
function loadOutline(page, n) {
  return page.evaluate((count) => {
    const lines = [];
    for (let i = 0; i < count; ++i) {
      const a = (2 * Math.PI * i) / count;
      const r = 4e5 + 5e4 * Math.sin(2 * a);
      lines.push(`(${(r * Math.cos(a)).toFixed(2)},${(r * Math.sin(a)).toFixed(2)})`);
    }
    evenlift.load(lines.join("\n"));
  }, n);
}

const vertices = (page) => page.evaluate(() => evenlift.text().trimEnd().split("\n").length);

for (const [n, ratio] of [
  [200000, 1],
  [200000, 1.5],
  [200000, 3],
  [1048576, 3],
]) {
  test(`${n} vertices are drawn with ${ratio} device pixels for a CSS pixel, and undo leads back`, async () => {
    const page = await browser.open({ drawn: true, deviceScaleFactor: ratio, colorScheme: "dark" });
    const before = await state(page);
    await idle(page);
    const frames = await page.evaluate(() => evenlift.frames);
    await loadOutline(page, n);
    await idle(page);
    assert.ok((await page.evaluate(() => evenlift.frames)) > frames, "it is drawn");
    assert.equal(await vertices(page), n);
    const [x, y] = await toScreen(page, [0, 300000]);
    const inside = await page.screenshot({ clip: { x: x - 20, y: y - 15, width: 40, height: 30 } });
    const beside = await page.screenshot({ clip: { x: 6, y: 300, width: 40, height: 30 } });
    assert.ok((await browser.compare(inside, beside)).share > 0.9, "it is filled");
    await page.locator("#canvas").focus();
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -200);
    await page.keyboard.press("0");
    await page.keyboard.press("Control+z");
    await idle(page);
    assert.deepEqual(await state(page), before);
    await page.done();
  });
}

test("one vertex more than is allowed is refused in a sentence", async () => {
  const page = await browser.open();
  const before = await link(page);
  const message = await page.evaluate(() => {
    try {
      evenlift.load("(1,1)\n".repeat(1048577));
    } catch (error) {
      return error.message;
    }
  });
  assert.match(message, /1048576|1,048,576/);
  assert.equal(await link(page), before);
  await page.done();
});

// --- Failures while the page runs ------------------------------------------------------------------------------------

// A browser without more memory, and one whose WebGL throws, at once or during a number of following starts.
function faults() {
  const doomed = location.protocol.startsWith("http") && localStorage.getItem("test.starts") > 0;
  const { grow } = WebAssembly.Memory.prototype;
  WebAssembly.Memory.prototype.grow = function (pages) {
    if (globalThis.noMemory) throw new RangeError("no more memory, says the test");
    return grow.call(this, pages);
  };
  const { drawElements } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.drawElements = function (...args) {
    if (globalThis.noPicture || doomed) throw new Error("no picture, says the test");
    return drawElements.apply(this, args);
  };
  if (doomed) localStorage.setItem("test.starts", localStorage.getItem("test.starts") - 1);
}

const faulty = (options = {}) => browser.open({ script: faults, quiet: false, ...options });

// Runs an action that stops the page, and waits for its restart, which may interrupt the action.
async function startsAnew(page, act) {
  await page.evaluate(() => {
    globalThis.thisStart = true;
  });
  await act().catch(() => {});
  await page.waitForFunction(
    () => !globalThis.thisStart && document.getElementById("cover")?.classList.contains("done"),
  );
}

async function savedAside(page) {
  const window = await openWindow(page, "save");
  const coming = page.waitForEvent("download");
  await window.getByRole("button", { name: /^Text 1/ }).click();
  const text = readFileSync(await (await coming).path(), "utf8");
  await page.keyboard.press("Escape");
  return text;
}

test("without memory for what is opened, the last polygon comes back with a message, and the text is kept", async () => {
  const page = await faulty();
  await load(page, asset("violin"));
  await set(page, { teams: 2 });
  await published(page);
  await idle(page);
  const good = await state(page);
  const large = Array.from(
    { length: 60000 },
    (_, i) =>
      `(${Math.round(1e6 * Math.cos((i / 60000) * 2 * Math.PI))},${Math.round(1e6 * Math.sin((i / 60000) * 2 * Math.PI))})`,
  ).join("\n");
  await startsAnew(page, () =>
    page.evaluate((text) => {
      globalThis.noMemory = true;
      try {
        evenlift.load(text);
      } catch (error) {
        globalThis.said = error.message;
      }
    }, large),
  );
  assert.match(
    await noticed(page),
    /^The page stopped while opening this, and has started again with the last polygon that was shown\. It is kept: use Save to get it as a file\.$/,
  );
  assert.deepEqual(await state(page), good);
  assert.equal(await savedAside(page), large);
  await set(page, { teams: 4 });
  assert.equal((await state(page)).requested_teams, 4, "it works");
  await page.done();
});

test("an exception while a picture is drawn: the same, and what had no picture is not kept", async () => {
  const page = await faulty();
  await load(page, asset("hammer"));
  await published(page);
  await idle(page);
  const good = await state(page);
  await startsAnew(page, () =>
    page.evaluate((text) => {
      globalThis.noPicture = true;
      evenlift.load(text);
    }, asset("star")),
  );
  assert.match(await noticed(page), /^The page stopped while opening this/);
  assert.deepEqual(await state(page), good);
  assert.equal(await savedAside(page), asset("star"));
  await page.done();
});

test("what was drawn a moment ago is what comes back", async () => {
  const page = await faulty();
  await load(page, asset("hammer"));
  await idle(page);
  const before = await page.evaluate(() => evenlift.frames);
  await page.evaluate(() => evenlift.set({ teams: 5 }));
  await page.waitForFunction((frames) => evenlift.frames > frames, before);
  const good = await state(page);
  await startsAnew(page, () =>
    page.evaluate((text) => {
      globalThis.noPicture = true;
      evenlift.load(text);
    }, asset("star")),
  );
  assert.deepEqual(await state(page), good);
  await page.done();
});

test("a call into a page that has stopped throws, and says so", async () => {
  const page = await faulty({ address: "?embed=1" });
  await page.evaluate(() => {
    globalThis.noPicture = true;
    evenlift.set({ teams: 2 });
  });
  await page.waitForFunction(() => !document.getElementById("problem").hidden);
  assert.match(await thrown(page, "link"), /stopped/);
  assert.match(await page.locator("#problem").textContent(), /The page has stopped/);
  await page.done();
});

// --- A start that fails ----------------------------------------------------------------------------------------------

test("a start that failed is not repeated with the same document, which is kept", async () => {
  const page = await faulty();
  const first = await state(page);
  await load(page, asset("guitar"));
  await published(page);
  const kept = await link(page);
  await idle(page);
  await page.evaluate(() => localStorage.setItem("test.starts", "1"));
  await startsAnew(page, () => page.goto(browser.server.url + "?plain"));
  assert.match(
    await noticed(page),
    /^The page stopped while opening the last polygon, so it was not opened again\. It is kept: use Save to get it as a file\.$/,
  );
  assert.deepEqual(await state(page), first);
  const saved = await savedAside(page);
  assert.equal(saved, kept);
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  assert.equal(await noticed(page), "");
  await load(page, saved);
  assert.equal(await link(page), kept, "what was kept opens again, now that nothing fails");
  await page.done();
});

test("a link that stopped a start is not opened again; the work of this browser is", async () => {
  const page = await faulty();
  await load(page, asset("guitar"));
  await published(page);
  await idle(page);
  const mine = await state(page);
  const other = await browser.open();
  await load(other, asset("anchor"));
  const bad = await link(other);
  await other.done();
  await page.evaluate(() => localStorage.setItem("test.starts", "1"));
  await startsAnew(page, () => page.goto(`${browser.server.url}?plain#${bad}`));
  assert.match(await noticed(page), /^The page stopped while opening this link, so it was not opened again\./);
  assert.deepEqual(await state(page), mine);
  await page.waitForFunction((l) => location.hash !== `#${l}`, bad);
  assert.equal(await savedAside(page), bad);
  await page.done();
});

test("a lesson in a link that stopped a start is not opened again; the work of this browser is", async () => {
  const page = await faulty();
  await load(page, asset("guitar"));
  await published(page);
  await idle(page);
  const mine = await state(page);
  const lesson = evenlift("link", "lesson", "opposite").trim();
  await page.evaluate(() => localStorage.setItem("test.starts", "1"));
  await startsAnew(page, () => page.goto(`${browser.server.url}?plain#${lesson}`));
  assert.match(await noticed(page), /^The page stopped while opening this lesson, so it was not opened again\./);
  assert.deepEqual(await state(page), mine);
  assert.equal(await savedAside(page), lesson);
  await page.done();
});

test("where nothing can be drawn at all it says so, and does not try for ever", async () => {
  const page = await faulty();
  await load(page, asset("guitar"));
  await published(page);
  await idle(page);
  await page.evaluate(() => localStorage.setItem("test.starts", "1000"));
  await page.goto(browser.server.url + "?plain", { waitUntil: "commit" }).catch(() => {});
  await page.locator("#problem strong").waitFor();
  assert.match(await page.locator("#problem").textContent(), /The page cannot run here/);
  const left = await page.evaluate(() => Number(localStorage.getItem("test.starts")));
  assert.ok(left >= 997, `${1000 - left} starts`);
  await page.done();
});

// A tab that never draws a frame; it reports when it has marked what it opens.
function withoutPictures() {
  globalThis.requestAnimationFrame = () => 0;
  const { setItem } = Storage.prototype;
  globalThis.marked = new Promise((done) => {
    Storage.prototype.setItem = function (key, value) {
      setItem.call(this, key, value);
      if (key === "evenlift.opening" && /^[0-9a-f]/.test(value)) done();
    };
  });
}

test("a tab that dies before its first picture has failed; one that is closed before has not", async () => {
  const context = await browser.browser.newContext({ viewport: wide });
  let page = await browser.open({ context });
  const first = await state(page);
  await load(page, asset("key"));
  await published(page);
  await idle(page);
  const mine = await state(page);
  await page.done();

  page = await browser.open({ context, ready: false, script: withoutPictures });
  await page.evaluate(() => globalThis.marked);
  await page.close();
  page = await browser.open({ context });
  assert.deepEqual(await state(page), mine);
  await page.done();

  page = await browser.open({ context, ready: false, script: withoutPictures, quiet: false });
  await page.evaluate(() => globalThis.marked);
  const client = await context.newCDPSession(page);
  const crashed = page.waitForEvent("crash");
  client.send("Page.crash").catch(() => {});
  await crashed;
  await page.close();
  page = await browser.open({ context });
  assert.deepEqual(await state(page), first);
  assert.match(await noticed(page), /not opened again/);
  await page.done();
  await context.close();
});
