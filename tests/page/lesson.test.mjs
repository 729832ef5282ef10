import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  control,
  controlIfShown,
  drag,
  drawsNothing,
  evenlift,
  fragment,
  idle,
  link,
  load,
  pageFolder,
  press,
  published,
  sample,
  set,
  sharedBrowser,
  state,
  summary,
  tap,
  thrown,
  toScreen,
} from "./browser.mjs";
import { allClosed, drop, noticed, openWindow, paste } from "./windows.mjs";

let maker; // a page that makes links
const browser = sharedBrowser({
  begin: async () => {
    maker = await browser.open();
  },
});

async function linkAt(name, step) {
  await load(maker, asset(name));
  await set(maker, { step });
  return link(maker);
}

const stone = JSON.parse(evenlift("trace", sample("stone-slab"), "--json"));
const find = (kind, item = 0) => stone.findIndex((s) => s.kind === kind && s.item === item);
const ready = JSON.parse(readFileSync(path.join(pageFolder, "lessons.json"), "utf8"));

// The stone at step 1000.
const beyondTheLast = "1.8CqeqKY7TMGrHNZK-59rGPFxpBqDhRjFOEC700";

const drawing = { x: 0, y: 70, width: 915, height: 550 };

// From 0; undefined without a lesson.
async function step(page) {
  return JSON.parse(evenlift("link", "decode", await link(page))).step ?? undefined;
}

async function stands(page, wanted, why) {
  assert.equal(await step(page), wanted, why);
}

async function goesOn(page, from) {
  assert.ok((await step(page)) > from);
}

async function spoken(page, pattern) {
  await idle(page);
  assert.match(await summary(page), pattern);
}

async function inLesson(name = "stone-slab", at = 0, options = {}) {
  const page = await browser.open({ reducedMotion: "reduce", ...options });
  await load(page, asset(name));
  await page.locator("#canvas").focus();
  await page.keyboard.press("b");
  await idle(page);
  if (at) await set(page, { step: at });
  await idle(page);
  return page;
}

test("it opens by its key and is left by it, and where it was left it begins again", async () => {
  const page = await browser.open();
  await load(page, asset("stone-slab"));
  const plain = await link(page);
  await page.keyboard.press("b");
  await spoken(page, /^Step 1 of \d+, The object/);
  await stands(page, 0);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("b");
  assert.equal(await link(page), plain);
  await spoken(page, /^6 robots/);
  await page.keyboard.press("b");
  await stands(page, find("centre"), "the second main step");
  await page.keyboard.press("Escape");
  assert.equal(await link(page), plain);
  await page.done();
});

test("every step forward and back, by keys: the same state, the same picture", async () => {
  const page = await inLesson("stone-slab", 0, { drawn: true });
  await page.keyboard.press("u");
  const links = [];
  const pictures = new Map();
  const looked = [3, find("outcome", 5), find("scores", 1), find("cut", 2)];
  for (let i = 0; i < stone.length; ++i) {
    links.push(await link(page));
    if (looked.includes(i)) {
      await idle(page);
      pictures.set(i, await page.screenshot({ clip: drawing }));
    }
    await page.keyboard.press("ArrowRight");
  }
  assert.equal(new Set(links).size, stone.length);
  await stands(page, stone.length - 1, "there is nothing after the last");
  for (let i = stone.length - 1; i >= 0; --i) {
    assert.equal(await link(page), links[i], `back at ${i}`);
    if (looked.includes(i)) {
      await idle(page);
      const { share } = await browser.compare(pictures.get(i), await page.screenshot({ clip: drawing }));
      assert.ok(share < 0.0005, `step ${i} looks different: ${share}`);
    }
    await page.keyboard.press("ArrowLeft");
  }
  await page.done();
});

test("the main steps come first: few of them, from the polygon to the result; a key unfolds all and folds them again", async () => {
  const page = await inLesson();
  const links = new Set();
  const main = [];
  for (let last; last !== (await link(page));) {
    last = await link(page);
    links.add(last);
    main.push(await step(page));
    await page.keyboard.press("ArrowRight");
  }
  const kinds = main.map((at) => stone[at].kind);
  assert.ok(links.size >= 12 && links.size <= 22, kinds.join());
  assert.deepEqual([kinds[0], kinds.at(-1)], ["polygon", "result"]);
  for (const kind of [
    "centre",
    "ray",
    "slopes",
    "sections",
    "outcome",
    "candidates",
    "scores",
    "team",
    "base",
    "loads",
    "coverage",
    "contacts",
    "closure",
  ])
    assert.ok(kinds.includes(kind), kind);
  const pair = main.find((at) => stone[at].kind === "outcome"); // the one that represents all
  await set(page, { step: pair });
  const more = stone.filter(({ kind }) => kind === "outcome").length - 1;
  await press(page, "All steps");
  await spoken(page, new RegExp(`^Step ${pair + 1} of ${stone.length}, `));
  await page.keyboard.press("ArrowRight");
  await stands(page, pair + 1);
  await page.keyboard.press("u");
  await stands(page, pair, "the main step before it");
  await spoken(page, new RegExp(`There are ${more} more pairs like it: “All steps” shows them`));
  await page.done();
});

test("a link to a step that is no main step opens with all steps around it", async () => {
  const at = find("sections", 4);
  const page = await browser.open({ address: `#${await linkAt("stone-slab", at)}` });
  await spoken(page, new RegExp(`^Step ${at + 1} of ${stone.length}, `));
  await page.keyboard.press("ArrowRight");
  await stands(page, at + 1);
  await page.done();
});

test("the timeline gives each chapter the same width, with main steps and with all", async () => {
  const page = await inLesson();
  const chapters = [...new Set(stone.map(({ chapter }) => chapter))];
  for (const all of [false, true]) {
    if (all) await page.keyboard.press("u");
    const { x, y, width, height } = await control(page, "timeline");
    for (const [i, chapter] of chapters.entries()) {
      // Just after a chapter's mark; the knob's middle stays 8 px from both ends.
      await page.mouse.click(x + 8 + ((width - 16) * (i + 0.02)) / chapters.length, y + height / 2);
      await idle(page);
      assert.equal(stone[await step(page)].chapter, chapter, `${all}`);
    }
  }
  await page.done();
});

test("presenting: large words, no settings, full screen, and Escape leaves it", async () => {
  const page = await inLesson();
  await page.evaluate(() => {
    globalThis.asked = 0;
    document.documentElement.requestFullscreen = async () => void ++globalThis.asked;
  });
  assert.ok(await control(page, "Samples"));
  await page.keyboard.press("P");
  await idle(page);
  const shown = (name) => page.evaluate((n) => Boolean(evenlift.view.control(n)), name);
  assert.deepEqual(
    [
      await page.evaluate(() => globalThis.asked),
      await shown("Samples"),
      await shown("Teams"),
      await shown("timeline"),
    ],
    [1, false, false, true],
  );
  const at = await step(page);
  await page.keyboard.press("ArrowRight");
  await goesOn(page, at);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.ok(await shown("Samples"));
  assert.ok((await step(page)) !== undefined, "the lesson is still open");
  await page.keyboard.press("P");
  await idle(page);
  assert.equal(await shown("Samples"), false);
  await page.evaluate(() => document.dispatchEvent(new Event("fullscreenchange"))); // as when the browser's own key
  // leaves it
  await idle(page);
  assert.ok(await shown("Samples"));
  await page.done();
});

test("on a phone the drawing stands still from step to step, and a question's button is in view", async () => {
  for (const viewport of [
    { width: 390, height: 844 },
    { width: 320, height: 568 },
  ]) {
    const page = await inLesson("stone-slab", 0, { viewport, hasTouch: true, isMobile: true });
    const corners = () =>
      page.evaluate(() => evenlift.state().polygon.map(([x, y]) => [...evenlift.view.to_screen(x, y)]));
    const row = await control(page, "Next step");
    const before = await corners();
    for (let i = 0; i < 6; ++i) {
      await page.keyboard.press("ArrowRight");
      await idle(page);
      assert.deepEqual(await corners(), before);
      assert.deepEqual(await control(page, "Next step"), row);
    }
    await page.keyboard.press("q");
    await page.keyboard.press("ArrowRight");
    await idle(page);
    const take = await control(page, "take");
    assert.ok(take.y + take.height <= row.y && take.x + take.width <= viewport.width, JSON.stringify(take));
    await page.done();
  }
});

test("embedded in a small frame, a question and its button are in view above one row of buttons", async () => {
  for (const viewport of [
    { width: 480, height: 360 },
    { width: 640, height: 480 },
  ]) {
    const page = await browser.open({ address: "?embed=1&lesson=metrics-area", viewport });
    await page.locator("#canvas").focus();
    await page.keyboard.press("ArrowRight");
    await idle(page);
    const row = await control(page, "Next step");
    const take = await control(page, "take");
    assert.ok(take.y + take.height <= row.y, JSON.stringify([take, row]));
    for (const name of ["play", "timeline", "player more", "out"])
      assert.ok(Math.abs((await control(page, name)).y - row.y) < 8, name);
    await page.done();
  }
});

test("buttons and keys: first, last, chapters, one on, one back", async () => {
  const page = await inLesson();
  await page.keyboard.press("u");
  const begin = (name) => stone.findIndex((s) => s.chapter === name);
  const last = stone.length - 1;
  for (const [key, button, at] of [
    ["End", "Last step", last],
    ["Home", "First step", 0],
  ]) {
    await page.keyboard.press(key);
    await stands(page, at, key);
    await page.keyboard.press(key === "End" ? "Home" : "End");
    await stands(page, last - at);
    await press(page, button);
    await stands(page, at, button);
  }
  await page.keyboard.press("PageDown");
  await stands(page, begin("vertex_chords"));
  await press(page, "Next chapter");
  await stands(page, begin("slopes"));
  await page.keyboard.press("PageDown");
  await stands(page, begin("pairs"));
  for (const more of [1, 2]) {
    await press(page, "Next step");
    await stands(page, begin("pairs") + more);
  }
  await press(page, "Previous step");
  await stands(page, begin("pairs") + 1);
  await press(page, "Previous chapter");
  await stands(page, begin("pairs"), "first to where the chapter begins");
  await page.keyboard.press("PageUp");
  await stands(page, begin("slopes"));
  await page.done();
});

test("playing goes on by itself, is read out when it pauses, and stops at the end; paused, nothing is drawn", async () => {
  const page = await inLesson("square", 0, { hasty: true });
  for (let i = 0; i < 6; ++i) await page.keyboard.press("ArrowUp"); // 32 times as fast
  await page.evaluate(() => {
    globalThis.said = 0;
    new MutationObserver(() => ++globalThis.said).observe(document.getElementById("summary"), {
      childList: true,
      characterData: true,
      subtree: true,
    });
  });
  await idle(page);
  await page.evaluate(() => {
    globalThis.said = 0;
  });
  await page.keyboard.press("Space");
  const began = Date.now();
  await page.waitForFunction((first) => evenlift.link() !== first, await link(page));
  await page.keyboard.press("Space");
  await page.mouse.move(1000, 600);
  const at = await step(page);
  await drawsNothing(page, "frames while it is paused");
  await stands(page, at);
  const last = await linkAt("square", JSON.parse(evenlift("trace", sample("square"), "--json")).length - 1);
  await press(page, "play");
  await page.waitForFunction((l) => evenlift.link() === l, last);
  const seconds = (Date.now() - began) / 1000;
  await spoken(page, /^Step (\d+) of \1,/);
  const said = await page.evaluate(() => globalThis.said);
  assert.ok(said <= seconds / 0.6 + 1, `${said} times in ${seconds} s`);
  await drawsNothing(page, "frames at the end");
  await page.done();
});

test("paused before its time, it does not draw when that would have come", async () => {
  const page = await inLesson("square", 5, { hasty: true });
  const frames = await page.evaluate(() => evenlift.frames);
  await page.keyboard.press("Space");
  await page.waitForFunction((before) => evenlift.frames > before + 2, frames); // it waits for its next step
  await page.keyboard.press("Space");
  const at = await step(page); // 5, unless a busy machine let a step pass
  await drawsNothing(page);
  await stands(page, at);
  await page.done();
});

test("the timeline is scrubbed by dragging, to the ends, too", async () => {
  const page = await inLesson();
  const { x, y: top, width, height } = await control(page, "timeline");
  const y = top + height / 2;
  await drag(page, [x + 10, y], [x + width / 2, y], 20);
  const middle = await step(page);
  const chapters = [...new Set(stone.map(({ chapter }) => chapter))];
  assert.ok(Math.abs(chapters.indexOf(stone[middle].chapter) - chapters.length / 2) <= 1, stone[middle].chapter);
  await drag(page, [x + width / 2, y], [x + width + 20, y], 20);
  await stands(page, stone.length - 1);
  await drag(page, [x + width - 10, y], [5, y], 20);
  await stands(page, 0);
  await page.done();
});

test("set({ step }) goes there, null leaves, and what is no step throws and changes nothing", async () => {
  const page = await browser.open();
  await load(page, asset("stone-slab"));
  for (const at of [7, 0, stone.length - 1]) {
    await set(page, { step: at });
    assert.equal(await link(page), await linkAt("stone-slab", at));
  }
  const before = await link(page);
  for (const bad of [stone.length, 1e9, -1, 2.5, "2", NaN]) {
    assert.match(await thrown(page, "set", { step: bad }), /step/, String(bad));
    assert.equal(await link(page), before);
  }
  await set(page, { step: null });
  assert.equal(await step(page), undefined);
  await page.done();
});

test("the link carries the step and opens there; one beyond the last is told", async () => {
  const at = find("team", 1);
  const page = await inLesson("stone-slab", at);
  await published(page);
  const other = await browser.open({ address: `#${await fragment(page)}` });
  assert.equal(await step(other), at);
  await spoken(other, /^Step \d+ of \d+, Further teams/);
  await spoken(page, /^Step \d+ of \d+, Further teams/);
  assert.equal(await summary(other), await summary(page));
  await other.done();
  const beyond = await browser.open({ address: `#${beyondTheLast}` });
  assert.match(await noticed(beyond), /has no step 1000: this is its last, \d+\./);
  assert.equal(await step(beyond), stone.length - 1);
  await beyond.done();
  await page.done();
});

test("an edit keeps the place, and so does undo", async () => {
  const at = find("team", 1);
  const page = await inLesson("stone-slab", at);
  const [x, y] = await toScreen(page, [1000, 300]);
  await drag(page, [x, y], [x - 20, y + 10]);
  assert.notDeepEqual((await state(page)).polygon[3], [1000, 300]);
  await spoken(page, /, Further teams\. /);
  const [, caption] = (await summary(page)).match(/teams\. (\S+ \S+)/);
  await page.keyboard.press("Control+z");
  await stands(page, at);
  await spoken(page, new RegExp(`Further teams\\. ${caption}`));
  assert.deepEqual((await state(page)).polygon[3], [1000, 300]);
  await page.done();
});

// On a candidate's chord, away from C and all other chords.
async function onCandidate(page, index) {
  const {
    candidates,
    centre_of_mass: [cx, cy],
  } = await state(page);
  const [[x, y]] = candidates[index].ends;
  return toScreen(page, [cx + 0.8 * (x - cx), cy + 0.8 * (y - cy)]);
}

const same = (a, b) => JSON.stringify(a.ends) === JSON.stringify(b.ends);

test("with predictions on it asks before a choice, and says whether the guess is right", async () => {
  for (const right of [true, false]) {
    const page = await inLesson("stone-slab", find("scores", 1) - 1);
    await page.keyboard.press("q");
    await page.keyboard.press("ArrowRight");
    assert.match(await noticed(page), /\?/, "a question");
    await stands(page, find("scores", 1) - 1, "the answer is not shown yet");
    const { candidates, teams } = await state(page);
    const choice = candidates.findIndex((c) => (right ? same(c, teams[1]) : !teams.some((t) => same(c, t))));
    await page.mouse.click(...(await onCandidate(page, choice)));
    await stands(page, find("scores", 1));
    assert.match(await noticed(page), right ? /^Right\./ : /^Not this time\. .*\d/);
    await spoken(page, right ? /\. Right\. / : /\. Not this time\. /);
    await page.done();
  }
});

test("where no step has a choice, predictions are not switched on, and that is said", async () => {
  const page = await browser.open({ address: "?lesson=slides" });
  await idle(page);
  await page.keyboard.press("q");
  assert.match(await noticed(page), /^No step here has a choice to predict\.$/);
  const predict = page.locator("#mirror").getByRole("button", { name: "Predict first" });
  assert.equal(await predict.getAttribute("aria-pressed"), "false");
  await page.done();
});

test("of two ends, too; and Next shows the answer to those who do not guess", async () => {
  const page = await inLesson("stone-slab", find("outcome", 5) - 1);
  await page.keyboard.press("q");
  await page.keyboard.press("ArrowRight");
  assert.match(await noticed(page), /\?/);
  await page.keyboard.press("ArrowRight");
  await stands(page, find("outcome", 5));
  await page.done();
});

test("a click on a candidate that was not taken says why, in numbers", async () => {
  const page = await inLesson("stone-slab", stone.length - 1);
  const { candidates, teams } = await state(page);
  await page.mouse.click(
    ...(await onCandidate(
      page,
      candidates.findIndex((c) => !teams.some((t) => same(c, t))),
    )),
  );
  const said = await noticed(page);
  assert.match(said, /score|ratio|gain/i);
  assert.match(said, /\d/);
  assert.match(said, /\.$/);
  await stands(page, stone.length - 1);
  await page.done();
});

test("every ready-made lesson opens from the window, and every stop has its words", async () => {
  assert.ok(ready.length >= 8);
  const page = await browser.open();
  for (const lesson of ready) {
    const window = await openWindow(page, "lessons");
    await window.locator(`[data-name="${lesson.name}"]`).click();
    await allClosed(page);
    if (!/^\[(?!(?:task|question|answer)\])/m.test(lesson.text)) {
      await page.locator("#task h2").waitFor();
      await page.waitForFunction((search) => location.search === search, `?lesson=${lesson.name}`);
      continue;
    }
    const words = lesson.text
      .split(/^\[question\]/m)[0]
      .split(/^\[.*\]\r?\n/m)
      .slice(1)
      .map((part) => part.trim().split(/\s+/).slice(0, 4).join(" "));
    for (const [i, first] of words.entries()) {
      await spoken(
        page,
        new RegExp(`^Step ${i + 1} of ${words.length}, [^.]*\\. ${first.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}`),
      );
      assert.doesNotMatch(await summary(page), /NaN|undefined|inf\b/);
      await page.keyboard.press("ArrowRight");
      if (await page.locator("#alert").textContent()) await page.keyboard.press("ArrowRight");
      await page.evaluate(() => document.getElementById("alert").replaceChildren());
    }
    assert.equal(new URL(page.url()).search, `?lesson=${lesson.name}`);
  }
  await page.locator("#task").getByRole("button", { name: "Leave the task" }).click();
  await page.waitForFunction(() => location.search === "");
  await page.done();
});

test("undo leaves a ready-made lesson for what was open before it", async () => {
  const page = await browser.open();
  await load(page, asset("cross"));
  const before = await link(page);
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "A moved centre" }).click();
  await spoken(page, /^Step 1 of 6/);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal(await link(page), before);
  await page.waitForFunction(() => location.search === "");
  await spoken(page, /robots carry/);
  await page.keyboard.press("Control+Shift+z");
  await idle(page);
  assert.equal((await state(page)).polygon.length, 8);
  await page.done();
});

const named = (page) => page.evaluate(() => location.search);

test("a copied address opens the same lesson at the same stop", async () => {
  const page = await browser.open({ address: "?lesson=moved", permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator("#canvas").focus();
  for (let i = 0; i < 2; ++i) await page.keyboard.press("ArrowRight");
  await spoken(page, /^Step 3 of 6, .*Some edge pairs/);
  await page.keyboard.press("Control+c");
  await noticed(page);
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(copied, /\?lesson=moved#1\./);
  const other = await browser.open({ address: copied.slice(browser.server.url.length) });
  await spoken(other, /^Step 3 of 6, .*Some edge pairs/);
  assert.equal(await named(other), "?lesson=moved");
  await other.reload();
  await other.evaluate(() => evenlift.ready);
  await spoken(other, /^Step 3 of 6, .*Some edge pairs/);
  // Another step of the same lesson, in the same tab.
  await page.keyboard.press("ArrowRight");
  await spoken(page, /^Step 4 of 6/);
  await other.evaluate(
    (l) => {
      location.hash = l;
    },
    await link(page),
  );
  await spoken(other, /^Step 4 of 6, .*Seven candidates/);
  assert.equal(await named(other), "?lesson=moved");
  await other.done();
  await page.done();
});

test("an edited polygon is not the lesson's any more, and its address does not say so", async () => {
  const page = await browser.open({ address: "?lesson=moved" });
  assert.equal(await named(page), "?lesson=moved");
  const [x, y] = await toScreen(page, [1000, 300]);
  await drag(page, [x, y], [x - 20, y + 10]);
  await published(page);
  assert.equal(await named(page), "");
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => location.search === "?lesson=moved");
  await load(page, asset("star"));
  await page.waitForFunction(() => location.search === "");
  await page.done();
});

test("a lesson with a link of another polygon: the link is opened, and the page says so", async () => {
  const page = await browser.open({ address: `?lesson=moved#${await linkAt("star", 4)}` });
  assert.match(
    await noticed(page),
    /^The lesson “moved” cannot be opened: it is about another polygon than the link\.$/,
  );
  assert.equal(await link(page), await linkAt("star", 4));
  await page.waitForFunction(() => location.search === "");
  await page.done();
});

test("a teacher's file beside the page opens by its name; other addresses do not", async (t) => {
  const place = path.join(pageFolder, "lesson-of-a-test.txt");
  const broken = path.join(pageFolder, "broken-lesson-of-a-test.txt");
  const long = path.join(pageFolder, "long-lesson-of-a-test.txt");
  writeFileSync(place, "title: Mine\npolygon: square\n\n[centre]\nLook here.\n\n[end]\nAnd there.\n");
  writeFileSync(broken, "title: Mine\npolygon: square\ncolour: red\n");
  writeFileSync(long, `title: Mine\n${"#".repeat(70000)}\n`);
  t.after(() => [place, broken, long].forEach((file) => rmSync(file)));
  const page = await browser.open({ address: "?lesson=lesson-of-a-test.txt" });
  await spoken(page, /^Step 1 of 2, .*Look here\./);
  await published(page);
  assert.equal(await named(page), "?lesson=lesson-of-a-test.txt");
  await page.done();
  for (const [name, why] of [
    ["broken-lesson-of-a-test.txt", /line 3: unknown setting/],
    ["long-lesson-of-a-test.txt", /65,536 bytes/],
    ["no-such-lesson", /no ready-made lesson/],
    ["../page/lesson-of-a-test.txt", /own folder/],
    ["%2e%2e/x.txt", /own folder/],
    ["https://example.org/x.txt", /own folder/],
    ["//example.org/x.txt", /own folder/],
    ["/lesson-of-a-test.txt", /own folder/],
    ["lessons.json", /own folder/],
    ["..\\x.txt", /own folder/],
    ["a%0A.txt", /own folder/],
    [`${"a".repeat(300)}.txt`, /own folder/],
  ]) {
    const other = await browser.open({ address: `?lesson=${name}` });
    assert.match(await noticed(other), why, name);
    assert.equal(await step(other), undefined, name);
    await other.done();
  }
  const missing = await browser.open({ address: "?lesson=no-such-file.txt", quiet: false }); // the browser itself
  // reports a 404
  assert.match(
    await noticed(missing),
    /^The lesson “no-such-file\.txt” cannot be opened: the server does not have it\.$/,
  );
  await missing.done();
});

test("a challenge link hides the answer and asks", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await load(page, asset("stone-slab"));
  const object = await link(page);
  await page.locator("#canvas").focus();
  await page.keyboard.press("b");
  const window = await openWindow(page, "save");
  await window.getByRole("button", { name: "Challenge link" }).click();
  await window.getByText("The challenge link is copied.").waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(copied, `${browser.server.url}?challenge=1#${object}`);
  await page.done();
  const other = await browser.open({ address: copied.slice(browser.server.url.length) });
  assert.equal(await step(other), 0);
  for (let i = 0; i < stone.length && !(await other.locator("#alert").textContent()); ++i)
    await other.keyboard.press("ArrowRight");
  assert.match(await other.locator("#alert").textContent(), /\?/);
  assert.equal(await named(other), "?challenge=1");
  await other.keyboard.press("b");
  await other.waitForFunction(() => location.search === "");
  await other.done();
  // A ready-made lesson's challenge, at a later step.
  const both = await browser.open({ address: "?lesson=moved&challenge=1" });
  for (let i = 0; i < 13 && !(await both.locator("#alert").textContent()); ++i) await both.keyboard.press("ArrowRight");
  assert.match(await both.locator("#alert").textContent(), /\?/);
  assert.equal(await named(both), "?lesson=moved&challenge=1");
  await both.done();
});

test("a challenge begins at the beginning, whatever step its link has, and has shown no other", async () => {
  const page = await browser.open({
    address: "?lesson=metrics-area",
    permissions: ["clipboard-read", "clipboard-write"],
  });
  await page.locator("#canvas").focus();
  await page.keyboard.press("End");
  await idle(page);
  const last = await link(page);
  const window = await openWindow(page, "save");
  await window.getByRole("button", { name: "Challenge link" }).click();
  await window.getByText("The challenge link is copied.").waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(copied, /\?lesson=metrics-area&challenge=1#1\./);
  assert.equal(
    JSON.parse(evenlift("link", "decode", copied.split("#")[1])).step ?? undefined,
    undefined,
    "the link has no step",
  );
  assert.equal(await link(page), last, "and what is open stays where it is");
  await page.done();
  const first = await browser.open({ address: "?lesson=metrics-area" });
  await idle(first);
  const begun = await step(first);
  await first.done();
  for (const [address, at, search] of [
    [copied.slice(browser.server.url.length), begun, "?lesson=metrics-area&challenge=1"],
    [`?lesson=metrics-area&challenge=1#${last}`, begun, "?lesson=metrics-area&challenge=1"],
    [`?challenge=1#${last}`, 0, "?challenge=1"],
  ]) {
    const other = await browser.open({ address });
    await idle(other);
    assert.equal(await step(other), at, address);
    await spoken(other, /^Step 1 of /);
    await published(other);
    assert.equal(await named(other), search);
    const before = await other.$$eval("#mirror [aria-label]", (all) =>
      all.map((e) => e.getAttribute("aria-label")).filter((label) => /^Step [\d–]/.test(label)),
    );
    assert.deepEqual(
      before.filter((label) => !label.includes("The object: a polygon")),
      [],
      "nothing that comes later was looked at",
    );
    await other.locator("#canvas").focus();
    for (let i = 0; i < 60 && !(await other.locator("#alert").textContent()); ++i) {
      await other.keyboard.press("ArrowRight");
      await idle(other);
    }
    assert.match(await other.locator("#alert").textContent(), /\?/, address);
    // A link at a step, put into the same tab, also starts from the beginning.
    await other.evaluate((l) => {
      location.hash = l;
    }, last);
    await spoken(other, /^Step 1 of /);
    await other.done();
  }
});

test("the window begins the polygon's own lesson, or a challenge from its first step", async () => {
  const page = await inLesson("stone-slab", 9);
  let window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: /^Step by step How/ }).click();
  await allClosed(page);
  await stands(page, 9, "where it was");
  window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: /^As a challenge/ }).click();
  await allClosed(page);
  await stands(page, 0);
  await page.done();
});

test("embedded, the player alone moves any moment of any lesson", async () => {
  for (const address of [`?embed=1#${await linkAt("stone-slab", find("scores", 1))}`, "?embed=1&lesson=moved"]) {
    const page = await browser.open({ drawn: true, address, viewport: { width: 800, height: 480 } });
    const shown = await page.screenshot();
    await page.locator("#canvas").focus();
    const at = await step(page);
    await page.keyboard.press("ArrowRight");
    await goesOn(page, at);
    assert.ok((await browser.compare(shown, await page.screenshot())).share > 0.002);
    await page.keyboard.press("Shift+B");
    await idle(page);
    assert.equal(await page.locator("dialog").count(), 0, "no windows");
    const coming = page.waitForEvent("popup");
    await press(page, "out");
    const opened = await coming;
    await opened.waitForLoadState();
    assert.equal(await opened.evaluate(() => location.search), address.includes("lesson") ? "?lesson=moved" : "");
    await page.done();
  }
});

const linked = `title: Linked\nlink: ${evenlift("link", "encode", sample("arrow")).trim()}\n\n[centre]\nHere is the centre.\n`;
const sampled = "\uFEFF# For a class.\npolygon: letter-k-moved\ntitle: A letter\n\n[end]\nHeld or not?\n";

test("a lesson's text is dropped, pasted, typed, chosen, or loaded by a script", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  await drop(page, { files: [["k.txt", sampled]] });
  await spoken(page, /^Step 1 of 1, .*Held or not\?/);
  assert.match(await noticed(page), /^“k\.txt” is opened\./);
  await load(page, asset("cross"));
  await paste(page, linked);
  await spoken(page, /Here is the centre\./);
  await load(page, asset("cross"));
  let window = await openWindow(page, "open");
  await window.locator("textarea").fill(sampled);
  await window.getByRole("button", { name: "Open" }).click();
  await spoken(page, /Held or not\?/);
  await load(page, linked);
  await spoken(page, /Here is the centre\./);
  assert.match(
    await thrown(page, "load", sampled),
    /only lessons that have a link; this one is about the sample “letter-k-moved”/,
  );
  window = await openWindow(page, "lessons");
  await window
    .locator("input[type=file]")
    .setInputFiles({ name: "k.txt", mimeType: "text/plain", buffer: Buffer.from(sampled) });
  await allClosed(page);
  await spoken(page, /Held or not\?/);
  assert.equal(await named(page), "", "an address cannot name it");
  await page.keyboard.press("b");
  await page.done();
});

const broken = [
  ["title: X\npolygon: square\nteams: none\n[end]\nWords.\n", /line 3: .*teams/i],
  ["title: X\npolygon: square\n[nowhere]\nWords.\n", /line 3: .*address/i],
  [
    "title: X\npolygon: square\n[team 40]\nWords.\n",
    /line 3: .*there is no step \[team 40\]: .*there are \[team 1\] to \[team \d\]/i,
  ],
  ["title: X\npolygon: square\n[end]\n", /line 3: .*no text/i],
  ["title: X\npolygon: square\ncom: 9,99999\n[end]\nWords.\n", /centre of mass/i],
  ["title: X\npolygon: no-such-sample\n[end]\nWords.\n", /sample “no-such-sample”, which does not exist/],
  ["title: X\npolygon: constructor\n[end]\nWords.\n", /“constructor”, which does not exist/],
  ["title: X\nlink: 1.AAAA\n[end]\nWords.\n", /link/i],
  ["title: X\npolygon: square\n[end]\nWo\uFFFDrds.\n", /line 4: not readable/i],
  [`title: X\npolygon: square\n[end]\nWords.\n${"#".repeat(70000)}`, /65,536 bytes/],
];

test("a broken lesson gets one sentence with its line, and changes nothing", async () => {
  const page = await browser.open();
  await load(page, asset("cross"));
  const before = await link(page);
  for (const [text, why] of broken) {
    await drop(page, { files: [["x.txt", text]] });
    const said = await noticed(page, why);
    assert.match(said, why, text.slice(0, 60));
    assert.match(said, /^“x\.txt” cannot be opened: [^\n]*[^.]\.$/);
    assert.equal(await link(page), before, text.slice(0, 60));
    const window = await openWindow(page, "lessons");
    await window
      .locator("input[type=file]")
      .setInputFiles({ name: "y.txt", mimeType: "text/plain", buffer: Buffer.from(text) });
    await window.locator(".problem:not(:empty)").waitFor();
    assert.match(await window.locator(".problem").textContent(), why);
    assert.equal(await link(page), before);
    await page.keyboard.press("Escape");
    await allClosed(page);
  }
  await page.done();
});

test("letters that no font of the page has are named by their writing", async () => {
  const page = await browser.open();
  await load(page, `title: 你好\nlink: ${await link(page)}\n\n[polygon]\nשלום, 世界 😀.\n`);
  assert.equal(
    await noticed(page),
    "Some characters cannot be shown on the canvas: Hebrew letters, Chinese characters, emoji.",
  );
  await page.done();
});

test("under a finger: buttons on a phone, and the sheet says the step", async () => {
  const page = await browser.open({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    address: "?lesson=opposite",
  });
  await idle(page);
  const at = await step(page);
  await tap(page, "Next step");
  await goesOn(page, at);
  await spoken(page, /^Step 2 of 6/);
  await page.done();
});

test("a step looks the same, whether the lesson began at it or came to it", async () => {
  const begun = await browser.open({ drawn: true });
  await load(begun, asset("arrow"));
  await begun.evaluate(() => {
    document
      .querySelector("#canvas")
      .dispatchEvent(new KeyboardEvent("keydown", { key: "b", code: "KeyB", bubbles: true }));
    evenlift.set({ step: 30 });
  });
  await idle(begun);
  const come = await inLesson("arrow", 30, { drawn: true });
  const { share } = await browser.compare(await begun.screenshot(), await come.screenshot());
  assert.equal(share, 0);
  await begun.done();
  await come.done();
});

test("on a phone on its side the player is one row, and the object has the room", async () => {
  const page = await browser.open({ viewport: { width: 740, height: 360 }, hasTouch: true, isMobile: true });
  await load(page, asset("horseshoe"));
  await page.keyboard.press("b");
  await idle(page);
  const [step, line] = [await control(page, "Next step"), await control(page, "timeline")];
  assert.ok(Math.abs(step.middle[1] - line.middle[1]) < 4, "buttons and timeline in one row");
  const high = await page.evaluate(() => {
    const all = evenlift.state().polygon.map(([x, y]) => evenlift.view.to_screen(x, y).y);
    return Math.max(...all) - Math.min(...all);
  });
  assert.ok(high >= 100, `${high} of 360`);
  await page.done();
});

test("on the smallest phone the buttons of a long question are seen whole", async () => {
  const page = await browser.open({
    viewport: { width: 320, height: 568 },
    hasTouch: true,
    isMobile: true,
    address: "?lesson=not-convex",
  });
  for (let i = 0; i < 20 && !(await controlIfShown(page, "take")); ++i) {
    await page.keyboard.press("ArrowRight");
    await idle(page);
  }
  const [take, next] = [await control(page, "take"), await control(page, "Next step")];
  assert.ok(take.y + take.height <= next.y, `${take.y + take.height} is above ${next.y}`);
  assert.ok(take.height >= 44);
  await page.done();
});

test("a setting that a script changes at the last step leaves the lesson at a step that it has", async () => {
  const page = await browser.open();
  await load(page, asset("stone-slab"));
  await set(page, { step: stone.length - 1 });
  await set(page, { teams: 1 });
  const now = await step(page);
  assert.ok(now > 0 && now < stone.length - 1, `step ${now}`);
  await page.done();
});
