// Order, seen lessons, a lesson's end, the editor, the handout, the glossary.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  control,
  drag,
  idle,
  link,
  openDrawers,
  load,
  lShape,
  phone,
  press,
  redo,
  reload,
  root,
  set,
  sharedBrowser,
  state,
  summary,
  toScreen,
  undo,
  wide,
} from "../page/browser.mjs";
import { allClosed, openWindow, violations } from "../page/windows.mjs";

const order = readFileSync(path.join(root, "assets/lessons/index.txt"), "utf8")
  .split("\n")
  .filter((line) => line && !line.startsWith("#"))
  .map((line) => line.split(/\s+/)[0]);

const browser = sharedBrowser();

async function begin(page, name) {
  const window = await openWindow(page, "lessons");
  await window.locator(`[data-name="${name}"]`).click();
  await allClosed(page);
}

const end = (page) => page.locator("#lesson-end");

async function goToEnd(page) {
  await page.keyboard.press("End");
  await idle(page);
}

test("lessons have their order, minutes, and a mark once they were played to the end, also after a reload", async () => {
  const page = await browser.open();
  let window = await openWindow(page, "lessons");
  const all = window.locator("ol .choice");
  assert.deepEqual(await all.evaluateAll((list) => list.map((b) => b.dataset.name)), order);
  for (const [i, words] of (await all.allTextContents()).entries())
    assert.match(words, new RegExp(`^${i + 1}\\. .+ about \\d+ min$`));
  await page.keyboard.press("Escape");
  await begin(page, order[1]);
  await page.keyboard.press("ArrowRight");
  await idle(page);
  assert.equal(await end(page).count(), 0, "the end has not come");
  await goToEnd(page);
  assert.match(await end(page).textContent(), new RegExp(`The end of lesson 2 of ${order.length}`));
  assert.deepEqual(await violations(page), []);
  await reload(page);
  assert.equal(await end(page).count(), 0, "a reload at the last step is no new end");
  window = await openWindow(page, "lessons");
  assert.match(await window.locator(`[data-name="${order[1]}"]`).textContent(), /open now|seen/);
  assert.match(await window.locator(`[data-name="${order[2]}"]`).textContent(), /next/);
  await page.keyboard.press("Escape");
  await begin(page, order[4]);
  await goToEnd(page);
  window = await openWindow(page, "lessons");
  assert.match(
    await window.locator(`[data-name="${order[5]}"]`).textContent(),
    /next/,
    "who went ahead goes on from there",
  );
  assert.doesNotMatch(await window.locator(`[data-name="${order[2]}"]`).textContent(), /next/);
  await page.done();
});

for (const [how, options] of [
  ["in a low window", { viewport: { width: 1280, height: 640 } }],
  ["on a phone", { viewport: phone, hasTouch: true, isMobile: true }],
]) {
  test(`the window fades out at its foot as long as there is more below, ${how}`, async () => {
    const page = await browser.open({ ...options, reducedMotion: "reduce" });
    const window = await openWindow(page, "lessons");
    const faded = window.locator(".foot-shade.more");
    await faded.waitFor({ state: "attached" });
    assert.equal(await faded.count(), 1);
    await window.evaluate((root) => {
      for (const each of [root, root.querySelector(".scroll")]) each.scrollTop = each.scrollHeight;
    });
    await faded.waitFor({ state: "detached" });
    await page.done();
  });
}

test("from the end, one key leads to the next lesson; going back takes the card away", async () => {
  const page = await browser.open();
  await begin(page, order[1]);
  await goToEnd(page);
  await page.keyboard.press("ArrowLeft");
  await idle(page);
  assert.equal(await end(page).count(), 0);
  await goToEnd(page);
  await end(page)
    .getByRole("button", { name: /^Next: / })
    .click();
  await idle(page);
  assert.equal(await end(page).count(), 0);
  assert.equal(await page.evaluate(() => new URLSearchParams(location.search).get("lesson")), order[2]);
  await page.done();
});

test("at the end, Escape closes the card, and only the next one leaves the lesson", async () => {
  const page = await browser.open();
  const lesson = () => page.evaluate(() => new URLSearchParams(location.search).get("lesson"));
  await begin(page, order[1]);
  await goToEnd(page);
  await end(page).waitFor();
  await page.locator("#canvas").focus();
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await end(page).count(), 0);
  assert.equal(await lesson(), order[1]);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await lesson(), null);
  await page.done();
});

test("at the end a question waits, its answer comes when it is asked for, and is there when the end comes again", async () => {
  const page = await browser.open();
  await begin(page, "moved");
  await goToEnd(page);
  assert.match(await end(page).textContent(), /How far must it go until there is room for six teams again\?/);
  assert.doesNotMatch(await end(page).innerText(), /About a third/);
  const before = await end(page).boundingBox();
  await end(page).getByRole("button", { name: "Answer", exact: true }).press("Enter");
  await idle(page);
  assert.deepEqual(await end(page).boundingBox(), before, "its room was kept, so that the drawing stands still");
  assert.match(await end(page).innerText(), /again\?\s+C must go about a third of the way/);
  assert.equal(await end(page).getByRole("button", { name: "Answer", exact: true }).count(), 0);
  assert.match(
    await page.evaluate(() => document.activeElement.textContent),
    /^Next: /,
    "the keyboard goes on from here",
  );
  assert.deepEqual(await violations(page), []);
  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowLeft");
  await idle(page);
  await page.keyboard.press("ArrowRight");
  await idle(page);
  assert.match(await end(page).textContent(), /about a third of the way/);
  await begin(page, "opposite");
  await goToEnd(page);
  assert.doesNotMatch(await end(page).innerText(), /No\. The centre of mass/, "another lesson's answer is not shown");
  await page.done();
});

test("while the question is tried on the shape, it stays", async () => {
  const page = await browser.open();
  await begin(page, "moved");
  await goToEnd(page);
  for (const [from, to] of [
    [
      [440, 330],
      [478, 354],
    ],
    [
      [1000, 300],
      [960, 320],
    ],
  ]) {
    // C, then a vertex
    await drag(page, await toScreen(page, from), await toScreen(page, to));
    await idle(page);
    assert.match(await end(page).textContent(), /room for six teams again\?/);
  }
  assert.deepEqual((await state(page)).teams.length, 6);
  await page.done();
});

test("a lesson from a file ends with its question, too, with paragraphs and without markup", async () => {
  const page = await browser.open();
  const window = await openWindow(page, "lessons");
  const text =
    "title: Mine\npolygon: square\n\n[centre]\nHere.\n\n[team 1]\nThere.\n\n[question]\nIs <b>1 < 2</b>?\n\nOr not?\n\n[answer]\nIt is.\n";
  await window
    .locator("input[type=file]")
    .setInputFiles({ name: "mine.txt", mimeType: "text/plain", buffer: Buffer.from(text) });
  await allClosed(page);
  await goToEnd(page);
  assert.deepEqual(await end(page).locator("p.question").allTextContents(), ["Is <b>1 < 2</b>?", "Or not?"]);
  await end(page).getByRole("button", { name: "Answer" }).click();
  await idle(page);
  assert.match(await end(page).textContent(), /It is\./);
  await page.keyboard.press("ArrowLeft");
  await idle(page);
  assert.equal(await end(page).count(), 0, "after a click the keys are the lesson's again");
  await page.done();
});

test("the card at the end covers no control of the player, wide and on a phone", async () => {
  for (const options of [
    {},
    { viewport: phone, hasTouch: true, isMobile: true },
    { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true },
  ]) {
    const page = await browser.open(options);
    await begin(page, order[1]);
    await goToEnd(page);
    const card = await end(page).boundingBox();
    // Low screens have the view's tools in the toolbar's menu.
    const tools = options.viewport?.height < 480 ? [] : ["Show the whole object"];
    for (const name of ["timeline", "play", "Next step", "Samples", ...tools]) {
      const place = await control(page, name);
      const apart =
        card.x + card.width <= place.x ||
        place.x + place.width <= card.x ||
        card.y + card.height <= place.y ||
        place.y + place.height <= card.y;
      assert.ok(apart, `${name}: ${JSON.stringify(card)} ${JSON.stringify(place)}`);
    }
    await page.done();
  }
});

for (const [width, height] of [
  [1280, 800],
  [1920, 1080],
]) {
  test(`at ${width} by ${height}, before a room, the card at the end takes its room from the words and not from the drawing, and covers no control`, async () => {
    const page = await browser.open({ viewport: { width, height }, reducedMotion: "reduce" });
    await begin(page, "moved");
    await page.keyboard.press("Shift+P");
    await idle(page);
    await page.keyboard.press("End");
    await page.keyboard.press("ArrowLeft");
    await idle(page);
    assert.equal(await end(page).count(), 0);
    const before = await toScreen(page, [0, 0]);
    await page.keyboard.press("ArrowRight");
    await end(page).waitFor();
    await idle(page);
    const check = async () => {
      assert.deepEqual(await toScreen(page, [0, 0]), before, "the drawing stands still");
      const card = await end(page).boundingBox();
      assert.ok(card.y + card.height <= height && card.height < 0.6 * height, JSON.stringify(card));
      for (const name of ["Previous step", "Next step", "timeline", "play"]) {
        const place = await control(page, name);
        assert.ok(place.y + place.height <= card.y, `${name}: ${JSON.stringify([card, place])}`);
      }
    };
    await check();
    await end(page).getByRole("button", { name: "Answer" }).click();
    await idle(page);
    await check();
    await page.done();
  });
}

test("before a room the card at the end is larger, as all else is, and no longer when that ends", async () => {
  const page = await browser.open();
  const sizes = () =>
    end(page).evaluate((card) => {
      const height = (selector) => card.querySelector(selector).getBoundingClientRect().height;
      return { cross: height(".away"), button: height(".primary") };
    });
  await begin(page, "moved");
  await goToEnd(page);
  await end(page).waitFor();
  const before = await sizes();
  await page.locator("#canvas").focus();
  await page.keyboard.press("Shift+P");
  await idle(page);
  const large = await sizes();
  for (const what of ["cross", "button"])
    assert.ok(large[what] > 1.3 * before[what], `${what}: ${before[what]}, ${large[what]}`);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Shift+P");
  await idle(page);
  assert.deepEqual(await sizes(), before);
  await page.done();
});

for (const [width, height] of [
  [390, 844],
  [844, 390],
  [320, 568],
  [1280, 800],
  [1920, 1080],
]) {
  test(`at ${width} by ${height} no button of the card at the end is cut or lies below another, nor before a room`, async () => {
    const page = await browser.open({
      viewport: { width, height },
      hasTouch: true,
      isMobile: true,
      reducedMotion: "reduce",
    });
    await begin(page, "moved");
    await goToEnd(page);
    await end(page).waitFor();
    const check = async (when) => {
      await idle(page);
      const { inWindow, card, buttons } = await end(page).evaluate((root) => {
        const box = (e) => {
          const { left, top, right, bottom } = e.getBoundingClientRect();
          return { name: e.textContent, left, top, right, bottom, cut: e.scrollWidth > e.clientWidth };
        };
        return {
          inWindow: box(root).bottom <= innerHeight,
          card: box(root),
          buttons: [...root.querySelectorAll("button")].filter((e) => e.checkVisibility()).map(box),
        };
      });
      assert.ok(inWindow, `${when}: ${JSON.stringify(card)}`);
      buttons.forEach((a, i) => {
        assert.ok(
          !a.cut && a.left >= card.left && a.right <= card.right && a.bottom <= card.bottom,
          `${when}: ${JSON.stringify(a)}`,
        );
        for (const b of buttons.slice(i + 1)) {
          assert.ok(
            a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top,
            `${when}: ${JSON.stringify([a, b])}`,
          );
        }
      });
    };
    await check("at the end");
    const question = end(page).getByRole("button", { name: "Question" });
    if (await question.isVisible()) {
      // where there is little room the card begins as a row of buttons
      await question.click();
      await check("unfolded");
    }
    await page.locator("#canvas").focus();
    await page.keyboard.press("Shift+P");
    await check("before a room");
    await end(page).getByRole("button", { name: "Answer" }).click();
    await check("with its answer");
    await page.done();
  });
}

test("guesses are counted, the first one at each step, and summed up at the end", async () => {
  const page = await browser.open();
  await load(page, asset("trapezium"));
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "As a challenge" }).click();
  await allClosed(page);
  // Takes the first choice at each question, which is sometimes right.
  const choices = ["The first end", "take", "Candidate 1", "Candidate 2", "Candidate 3", "Candidate 4"];
  let asked = 0;
  while (!(await end(page).count())) {
    const choice = await page.evaluate((names) => names.find((name) => evenlift.view.control(name)), choices);
    if (choice) {
      ++asked;
      await press(page, choice);
    } else {
      await page.locator("#canvas").focus();
      await page.keyboard.press("ArrowRight");
    }
    await idle(page);
  }
  assert.ok(asked > 1, String(asked));
  const [, right, all] = /(\d+) of (\d+) guess(?:es)? w/.exec(await end(page).textContent());
  assert.equal(Number(all), asked);
  assert.ok(Number(right) <= asked);
  await page.done();
});

// --- Leaving a lesson -------------------------------------------------------------------------------------------------

// The open document, to compare with a later one.
const open = async (page) => ({ link: await link(page), search: await page.evaluate(() => location.search) });

// A drawing with its own settings, an edit to undo and one to redo.
async function drawing(browser) {
  const page = await browser.open();
  await load(page, asset("violin"));
  await set(page, { teams: 4, metric: "distance", min_ratio: 0.7 });
  const former = await link(page);
  await set(page, { weight: 250 });
  await set(page, { seed: 9 });
  const later = await link(page);
  await page.locator("#canvas").focus();
  await undo(page);
  return { page, before: await open(page), former, later };
}

// As before the lesson.
async function sameHistory(page, { former, before, later }) {
  await redo(page);
  assert.equal(await link(page), later, "what could be done again");
  await undo(page);
  assert.equal(await link(page), before.link);
  await undo(page);
  assert.equal(await link(page), former, "one undo is of the edit before the lesson");
}

async function leave(page, key = "b") {
  await page.locator("#canvas").focus();
  await page.keyboard.press(key);
  await idle(page);
}

for (const key of ["b", "Escape"]) {
  test(`${key} leaves a lesson for the drawing, the settings and the undo from before it`, async () => {
    const { page, ...was } = await drawing(browser);
    await begin(page, "opposite");
    assert.equal((await state(page)).requested_teams, 1);
    await page.keyboard.press("ArrowRight");
    await idle(page);
    await leave(page, key);
    assert.deepEqual(await open(page), was.before);
    assert.equal((await state(page)).metric, "distance");
    await sameHistory(page, was);
    await page.done();
  });
}

test("a script leaves a lesson as a person does", async () => {
  const { page, ...was } = await drawing(browser);
  await begin(page, "opposite");
  await set(page, { step: null });
  await idle(page);
  assert.deepEqual(await open(page), was.before);
  await sameHistory(page, was);
  await load(page, `title: Mine\nlink: ${was.later}\n\n[centre]\nHere.\n`);
  await idle(page);
  await set(page, { step: null });
  assert.equal(await link(page), was.former, "one that a script opened, too");
  await page.done();
});

test("from lesson to lesson and then out: what was open before the first is back, by closing and by one undo", async () => {
  for (const way of [(page) => leave(page), undo]) {
    const { page, ...was } = await drawing(browser);
    await begin(page, order[1]);
    await goToEnd(page);
    await end(page)
      .getByRole("button", { name: /^Next: / })
      .click();
    await idle(page);
    await page.locator("#canvas").focus();
    await begin(page, order[4]);
    await way(page);
    assert.deepEqual(await open(page), was.before);
    await undo(page);
    assert.equal(await link(page), was.former);
    await page.done();
  }
});

test("what was edited in a lesson is one undo away when it is left, and a notice says so", async () => {
  const { page, before, former } = await drawing(browser);
  await begin(page, "moved");
  await goToEnd(page);
  await drag(page, await toScreen(page, [440, 330]), await toScreen(page, [478, 354]));
  await set(page, { teams: 2 });
  const { polygon, centre_of_mass: centre } = await state(page);
  await leave(page);
  assert.deepEqual(await open(page), before);
  assert.equal(
    await page.locator("#alert").textContent(),
    "Your work from before the lesson is back. Undo shows the lesson's object as you left it.",
  );
  await undo(page);
  const again = await state(page);
  assert.deepEqual([again.polygon, again.centre_of_mass, again.requested_teams], [polygon, centre, 2]);
  await redo(page);
  assert.deepEqual(await open(page), before);
  for (let i = 0; i < 5; ++i) await undo(page); // leaving, two edits, the lesson, and the edit before it
  assert.equal(await link(page), former);
  await page.done();
});

test("a lesson that was loaded anew in its midst is left for what was open before it, too", async () => {
  const { page, ...was } = await drawing(browser);
  await begin(page, "moved");
  await page.keyboard.press("ArrowRight");
  await idle(page);
  await reload(page);
  assert.match(page.url(), /lesson=moved/);
  assert.match(await summary(page), /^Step 2 of 6/);
  await leave(page);
  assert.deepEqual(await open(page), was.before);
  await undo(page);
  assert.equal(await link(page), was.former);
  // Again after an edit, and with a lesson that no address can name.
  await begin(page, "moved");
  await set(page, { teams: 2 });
  await reload(page);
  await leave(page);
  assert.equal(await link(page), was.former);
  await page.locator("#canvas").focus();
  const window = await openWindow(page, "lessons");
  await window
    .locator("input[type=file]")
    .setInputFiles({
      name: "mine.txt",
      mimeType: "text/plain",
      buffer: Buffer.from("title: Mine\npolygon: square\n\n[centre]\nHere.\n"),
    });
  await allClosed(page);
  assert.equal((await state(page)).polygon.length, 4);
  await reload(page);
  await leave(page);
  assert.equal(await link(page), was.former);
  await page.done();
});

test("an undo in a lesson that was loaded anew takes back an edit, and not the lesson", async () => {
  const page = await browser.open();
  await begin(page, "moved");
  await set(page, { teams: 2 });
  await idle(page);
  await reload(page);
  await page.locator("#canvas").focus();
  await undo(page);
  assert.match(await summary(page), /^Step 1 of 6/);
  assert.match(page.url(), /lesson=moved/);
  await page.done();
});

test("with all steps around it, and after a look at the steps of its object, a lesson is left as ever", async () => {
  const { page, before } = await drawing(browser);
  await begin(page, "opposite");
  await page.keyboard.press("u");
  await idle(page);
  await leave(page);
  assert.deepEqual(await open(page), before);
  await begin(page, "opposite");
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: /^Step by step/ }).click();
  await allClosed(page);
  await leave(page);
  assert.deepEqual(await open(page), before);
  await page.done();
});

test("what is shown and compared is back, too; the lesson itself has the whole picture", async () => {
  const page = await browser.open();
  await set(page, { overlays: ["candidates", "halo"] });
  await page.locator("#canvas").focus();
  await page.keyboard.press("k");
  await openDrawers(page, "Compare");
  const compared = () =>
    page
      .locator("#mirror")
      .getByRole("combobox", { name: "Compare with" })
      .evaluate((list) => list.selectedOptions[0].text);
  const before = [await link(page), await compared()];
  await begin(page, "convex");
  assert.doesNotMatch(await page.locator("#news").textContent(), /Compared with/);
  await leave(page);
  assert.deepEqual([await link(page), await compared()], before);
  await page.done();
});

test("in a frame a lesson's object stays when it is left", async () => {
  const page = await browser.open({ address: "?embed=1&lesson=moved" });
  await idle(page);
  const { polygon } = await state(page);
  await leave(page);
  assert.deepEqual((await state(page)).polygon, polygon);
  await page.done();
});

test("the sample of a lesson that there is not: those with nearly that name are told", async () => {
  const page = await browser.open();
  await openWindow(page, "open");
  await page.locator("#open textarea").fill("title: x\npolygon: stone-slap\n\n[centre]\nHere.\n");
  await page.locator("#open").getByRole("button", { name: "Open", exact: true }).click();
  await idle(page);
  assert.match(
    await page.locator("#open .problem").textContent(),
    /“stone-slap”, which does not exist; similar names are “stone-slab”, “.+” and “.+”\.$/,
  );
  await page.done();
});

// --- The editor ------------------------------------------------------------------------------------------------------

async function editor(page) {
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "Write a lesson" }).click();
  const root = page.locator("#editor");
  await root.waitFor();
  await idle(page);
  return { root, text: root.locator("textarea"), problem: root.locator(".problem") };
}

for (const [how, options] of [
  ["beside it", {}],
  ["above it on a phone", { viewport: phone, hasTouch: true, isMobile: true }],
  ["above it on a small phone", { viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true }],
]) {
  test(`the editor does not cover the card at the lesson's end, which stands ${how}`, async () => {
    const page = await browser.open(options);
    const { root, text } = await editor(page);
    await text.press("Control+End");
    await end(page).waitFor();
    await idle(page);
    const [card, window] = [await end(page).boundingBox(), await root.boundingBox()];
    assert.ok(card.x >= window.x + window.width || card.y + card.height <= window.y, JSON.stringify({ card, window }));
    assert.ok(card.y >= 0 && card.x + card.width <= page.viewportSize().width);
    await page.done();
  });
}

test("who only looks into the editor gets back the lesson or the polygon that was open", async () => {
  const page = await browser.open();
  const before = await link(page);
  await editor(page);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await link(page), before);
  await begin(page, "convex");
  await page.keyboard.press("ArrowRight");
  await idle(page);
  const step = await summary(page);
  await editor(page);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await summary(page), step);
  assert.match(page.url(), /lesson=convex/);
  await page.done();
});

const stepOf = (page) =>
  page.evaluate(() => evenlift.view.control("timeline") && document.getElementById("summary").textContent);

test("the editor shows the lesson at the step of the cursor, and its problems with their lines, and undo takes all of it back", async () => {
  const page = await browser.open();
  await load(page, asset("horseshoe"));
  await idle(page);
  const before = await link(page);
  const { root: window, text, problem } = await editor(page);
  assert.match(await text.inputValue(), /^title: My lesson$/m);
  assert.match(await stepOf(page), /^Step 1 of 5/);
  const lesson = "title: Mine\npolygon: stone-slab\nteams: 2\n\n[centre]\nFirst words.\n\n[team 2]\nSecond words.\n";
  await text.fill(lesson);
  await idle(page);
  assert.equal(await problem.textContent(), "");
  assert.match(await stepOf(page), /Step 2 of 2.*Second words\./);
  await text.evaluate((t) => t.setSelectionRange(t.value.indexOf("First"), t.value.indexOf("First")));
  await idle(page);
  assert.match(await stepOf(page), /Step 1 of 2.*First words\./);
  await text.fill(lesson.replace("[team 2]", "[taem 2]"));
  await idle(page);
  assert.match(await problem.textContent(), /^Line 8: /);
  assert.equal(await text.getAttribute("aria-invalid"), "true");
  assert.match(await stepOf(page), /Step 1 of 2.*First words\./, "the last good version stays");
  await text.fill(lesson);
  await idle(page);
  assert.equal(await problem.textContent(), "", "what was right before is right again");
  assert.equal(await text.getAttribute("aria-invalid"), null);
  await text.fill(lesson.replace("stone-slab", "stone-slub"));
  await idle(page);
  assert.match(await problem.textContent(), /^Line 2: .*“stone-slab”/);
  await text.fill(lesson.replace("[team 2]", "[team 1]"));
  await idle(page);
  assert.equal(await problem.textContent(), "");
  assert.match(await window.locator(".status").textContent(), /^2 steps; /);
  await page.keyboard.press("Escape");
  await allClosed(page);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal(await link(page), before, "all previews are one step");
  const again = await editor(page);
  assert.equal(await again.text.inputValue(), lesson.replace("[team 2]", "[team 1]"), "the draft is kept");
  await page.done();
});

// The template's steps, by the open document.
for (const [what, settings, steps] of [
  ["area", { metric: "area" }, 5],
  ["circle", { metric: "circle" }, 5],
  ["distance", { metric: "distance" }, 5],
  ["distributed", { metric: "distributed" }, 4],
  ["random", { metric: "random" }, 3],
  ["balanced robots", { metric: "balanced" }, 5],
  ["two balanced robots", { metric: "balanced", robots: 2 }, 5],
]) {
  test(`the untouched template has no mistake: ${what}`, async () => {
    const page = await browser.open();
    await load(page, asset("horseshoe"));
    await set(page, settings);
    await idle(page);
    const { root: window, text, problem } = await editor(page);
    assert.equal(await problem.textContent(), "");
    assert.equal(await text.getAttribute("aria-invalid"), null);
    assert.match(await window.locator(".status").textContent(), new RegExp(`^${steps} steps; `));
    assert.match(await stepOf(page), new RegExp(`^Step 1 of ${steps}`));
    await page.done();
  });
}

test("the untouched template has no mistake where no team stands, and where a balanced robot was moved", async () => {
  const page = await browser.open();
  const check = async () => {
    const { root: window, problem } = await editor(page);
    await window.getByLabel("Begin with").selectOption("template");
    await idle(page);
    assert.equal(await problem.textContent(), "");
    await page.keyboard.press("Escape");
    await allClosed(page);
  };
  await load(page, lShape);
  await set(page, { com: [300, 200], min_ratio: 1 });
  assert.equal((await state(page)).teams.length, 0);
  await check();
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced", robots: 3, min_ratio: 0.8 });
  await idle(page);
  const {
    teams,
    centre_of_mass: [cx, cy],
  } = await state(page);
  const [x, y] = teams[0].ends[0];
  await drag(page, await toScreen(page, [x, y]), await toScreen(page, [x - 0.05 * (y - cy), y + 0.05 * (x - cx)]));
  assert.notEqual((await state(page)).moved, undefined);
  await check();
  await page.done();
});

test("what the editor says about an unknown setting names every one that a lesson may have", async () => {
  const page = await browser.open();
  const { text, problem } = await editor(page);
  await text.fill("title: Mine\ncolour: red\n");
  await idle(page);
  const said = /^Line 2: unknown setting; the settings are (.+)\.$/.exec(await problem.textContent())[1];
  const options = [...readFileSync(path.join(root, "docs/cli.md"), "utf8").matchAll(/^\| `--([a-z-]+)/gm)].map(
    ([, name]) => name,
  );
  const names = said.split(/, | and /);
  const [own, settings] = [
    [
      "title",
      "polygon",
      "link",
      "generate",
      "predict",
      "overlays",
      "require",
      "move",
      "place",
      "find",
      "loads",
      "failed",
    ],
    ["teams", "robots", "capacity", "unit"],
  ];
  for (const name of [...own, ...settings]) assert.ok(names.includes(name), name);
  for (const name of names) assert.ok(own.includes(name) || options.includes(name), name);
  await page.getByRole("button", { name: "Go to line 2" }).click();
  assert.equal(
    await text.evaluate((field) => field.value.slice(field.selectionStart, field.selectionEnd)),
    "colour: red",
  );
  await page.done();
});

test("two tabs in which lessons are written keep a draft of their own, and the next visit has the last one", async () => {
  const context = await browser.browser.newContext({ viewport: wide });
  const [a, b] = [await browser.open({ context }), await browser.open({ context })];
  const written = (name) => `title: ${name}\npolygon: square\n\n[centre]\nHere.\n`;
  for (const [page, name] of [
    [a, "One"],
    [b, "Two"],
  ]) {
    await page.bringToFront();
    const { text } = await editor(page);
    await text.fill(written(name));
    await idle(page);
  }
  const c = await browser.open({ context });
  assert.equal(await (await editor(c)).text.inputValue(), written("Two"));
  await a.bringToFront();
  await reload(a);
  assert.equal(await (await editor(a)).text.inputValue(), written("One"));
  for (const page of [a, b, c]) await page.done();
  await context.close();
});

test("a sample is chosen from a list, a lesson begins with a ready-made one, and a file is saved that opens", async () => {
  const page = await browser.open({ acceptDownloads: true });
  const { root: window, text, problem } = await editor(page);
  const titles = await window.getByLabel("Sample polygon").locator("option").allTextContents();
  assert.ok(titles.includes("Trapezium") && titles.includes("Trapezium, moved"), titles.join(", "));
  for (const title of titles) assert.match(title, /^[A-Z\d“][^_]*$/, "a title, not a file's name");
  await window.getByLabel("Sample polygon").selectOption("trapezium");
  await idle(page);
  assert.match(await text.inputValue(), /^polygon: trapezium$/m);
  assert.doesNotMatch(await text.inputValue(), /^link:/m);
  assert.equal(await problem.textContent(), "");
  await window.getByLabel("Begin with").selectOption("lesson equal-arms");
  await idle(page);
  assert.match(await text.inputValue(), /Equal arms, equal loads/);
  const coming = page.waitForEvent("download");
  await window.getByRole("button", { name: "Save as a file" }).click();
  const file = await coming;
  assert.equal(file.suggestedFilename(), "equal-arms-equal-loads.txt");
  assert.equal(readFileSync(await file.path(), "utf8"), await text.inputValue());
  await page.done();
});

test("the editor stands clear of the drawing and has no fault that axe finds, light, dark and on a phone", async () => {
  for (const options of [{}, { colorScheme: "dark" }, { viewport: phone, hasTouch: true, isMobile: true }]) {
    const page = await browser.open({ ...options, reducedMotion: "reduce" });
    const { root: window } = await editor(page);
    assert.deepEqual(await violations(page), []);
    const { x, y, width, height } = await window.boundingBox();
    const corners = await page.evaluate(() =>
      [...evenlift.text().matchAll(/^\(([^,]+),([^)]+)\)/gm)].map(([, a, b]) => [
        ...evenlift.view.to_screen(Number(a), Number(b)),
      ]),
    );
    for (const [px, py] of corners)
      assert.ok(px < x || px > x + width || py < y || py > y + height, `a vertex at ${[px, py]} is behind the window`);
    await page.done();
  }
});

// --- The handout and the glossary -----------------------------------------------------------------------------------

test("the handout has a picture and the words for each stop of the lesson, and only it is printed", async () => {
  const page = await browser.open();
  await begin(page, "convex");
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "Handout" }).click();
  const figures = page.locator("#handout figure");
  await figures.first().waitFor();
  await idle(page);
  const lesson = readFileSync(path.join(root, "assets/lessons/convex.txt"), "utf8");
  assert.equal(await figures.count(), lesson.match(/^\[(?!question|answer)/gm).length);
  assert.match(
    await page.locator("#handout .paper-question").textContent(),
    /A question.*Do the even chords stay even\?.*an even chord moves along with C/,
  );
  assert.match(await figures.first().textContent(), /eight vertices, and no corner points inwards/);
  assert.equal(await page.locator("#handout figure svg .object").count(), await figures.count());
  assert.match(
    await figures.nth(3).locator("svg").textContent(),
    /edge 4.*edge 1|edge 1.*edge 4/,
    "what its caption speaks of",
  );
  const last = figures.last().locator("svg");
  assert.match(await last.textContent(), /16\.7\u00A0kg/);
  assert.equal(await last.locator(".robot").count(), 6, "three teams at the end");
  assert.match(
    await page.locator("#handout .paper-legend").textContent(),
    /a candidate.*the image of an edge/,
    "the lines are named",
  );
  const covered = await figures.evaluateAll((all) =>
    all.flatMap((figure, number) => {
      const boxes = (selector) =>
        [...figure.querySelectorAll(selector)].map((e) => ({
          name: e.textContent || selector,
          ...e.getBoundingClientRect().toJSON(),
        }));
      const words = boxes("svg .words"),
        marks = [...boxes("svg .robot"), ...boxes("svg .centre")];
      return words.flatMap((a, i) =>
        [...words.slice(i + 1), ...marks]
          .filter((b) => a.left < b.right && b.left < a.right && a.top + 2 < b.bottom && b.top < a.bottom - 2)
          .map((b) => `${number + 1}: ${a.name} on ${b.name}`),
      );
    }),
  );
  assert.deepEqual(covered, [], "no words lie on others or on a robot");
  assert.deepEqual(await violations(page), []);
  await page.emulateMedia({ media: "print" });
  const seen = await page.evaluate(() => ({
    canvas: document.getElementById("canvas").checkVisibility(),
    figures: [...document.querySelectorAll("#handout figure")].every((f) => f.checkVisibility()),
    button: document.querySelector("#handout footer").checkVisibility(),
  }));
  assert.deepEqual(seen, { canvas: false, figures: true, button: false });
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  assert.ok(height > 1500, "all of it is laid out, not a window's height of it");
  const outside = await page.evaluate(
    () =>
      [...document.querySelectorAll("#handout figure")]
        .map((f) => f.getBoundingClientRect())
        .filter(({ left, right }) => left < 0 || right > document.documentElement.clientWidth).length,
  );
  assert.equal(outside, 0, "no picture begins or ends beyond the paper");
  await page.done();
});

test("on a handout the candidates that a caption compares have their numbers in its picture", async () => {
  const page = await browser.open();
  await begin(page, "metrics-area");
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "Handout" }).click();
  const figures = page.locator("#handout figure");
  await figures.first().waitFor();
  let compared = 0;
  for (const figure of await figures.all()) {
    const named = [...(await figure.textContent()).matchAll(/candidate (\d+) has/gi)].map(([, number]) => number);
    const words = await figure.locator("svg .words").allTextContents();
    for (const number of named) assert.ok(words.includes(number), `${number} of ${named}: ${words}`);
    compared += named.length;
  }
  assert.ok(compared >= 4);
  await page.done();
});

test("the handout of a lesson about balanced robots has the robots, with their own numbers", async () => {
  const page = await browser.open();
  await begin(page, "exchange");
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "Handout" }).click();
  const figures = page.locator("#handout figure");
  await figures.first().waitFor();
  for (const figure of await figures.all())
    assert.deepEqual((await figure.locator(".robot-number").allTextContents()).sort(), ["1", "2", "3", "4", "5", "6"]);
  assert.ok((await page.locator("#handout .left").count()) > 0, "where robots stood before");
  assert.match(await page.locator("#handout .paper-legend").textContent(), /an even chord.*where a robot moves/);
  await page.done();
});

test("the printed handout begins at the head of its first page", async () => {
  const page = await browser.open();
  await begin(page, "convex");
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "Handout" }).click();
  await page.locator("#handout figure").first().waitFor();
  await idle(page);
  await page.emulateMedia({ media: "print" });
  const [title, first] = [
    await page.locator("#handout .paper-title").boundingBox(),
    await page.locator("#handout figure").first().boundingBox(),
  ];
  assert.ok(title.y >= 0 && title.y < 40, `the title is ${title.y} pixels from the paper's head`);
  assert.ok(first.y > title.y, "and the first step is below it");
  for (const sample of await page.locator("#handout .paper-legend svg").all())
    assert.ok((await sample.boundingBox()).height < 20, "a line of the list");
  await page.emulateMedia({ media: "screen" });
  await page.done();
});

test("without a lesson the handout has the main steps of the polygon", async () => {
  const page = await browser.open();
  await load(page, asset("arrow"));
  const window = await openWindow(page, "lessons");
  await window.getByRole("button", { name: "Handout" }).click();
  const figures = page.locator("#handout figure");
  await figures.first().waitFor();
  const captions = (await figures.allTextContents()).join("\n");
  assert.ok((await figures.count()) >= 10 && (await figures.count()) <= 25, String(await figures.count()));
  for (const word of [/Team 1 takes/, /Team 3 takes/, /cover/i]) assert.match(captions, word);
  await page.done();
});
