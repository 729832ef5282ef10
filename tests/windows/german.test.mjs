// The page's windows in German, and the choice of language.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  fragment,
  idle,
  link,
  load,
  phone,
  press,
  set,
  sharedBrowser,
  state,
  summary,
  type,
} from "../page/browser.mjs";
import { allClosed, openWindow } from "../page/windows.mjs";

const browser = sharedBrowser();

// Words that no German sentence has. Lessons and documents are in English.
const english = /\b(the|of|and|is|are|to|with|without|from|by|or|not|it|this|robots|edges?)\b/;
const windows = ["samples", "open", "save", "table", "experiment", "keys", "glossary"];

// In HTML: controls, windows and live regions.
function said(page) {
  return page.evaluate(() => {
    const texts = [document.title, document.getElementById("summary").textContent];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const parent = walker.currentNode.parentElement;
      if (!parent.closest("script, style, noscript, cite, code, pre, textarea, [lang=en]"))
        texts.push(walker.currentNode.data);
    }
    for (const element of document.querySelectorAll("[aria-label], [title], [placeholder]"))
      for (const name of ["aria-label", "title", "placeholder"]) texts.push(element.getAttribute(name) ?? "");
    return texts.map((text) => text.replace("centre of gravity", "").trim()).filter(Boolean); // a term in the glossary
  });
}

async function staysEnglish(page) {
  return [...new Set((await said(page)).filter((text) => english.test(text)))];
}

for (const [how, options] of [
  ["wide", {}],
  ["on a phone", { viewport: phone, hasTouch: true, isMobile: true }],
])
  test(`controls and windows are German, ${how}`, async () => {
    const page = await browser.open({ ...options, address: "?lang=de", reducedMotion: "reduce" });
    assert.equal(await page.evaluate(() => document.documentElement.lang), "de");
    assert.match(await summary(page), /Roboter/);
    assert.deepEqual(await staysEnglish(page), [], "without a window");
    for (const name of windows) {
      await openWindow(page, name);
      assert.deepEqual(await staysEnglish(page), [], name);
      await page.keyboard.press("Escape");
      await allClosed(page);
    }
    await page.done();
  });

test("a refused text says why in German, and a typed German word is understood", async () => {
  const page = await browser.open({ address: "?lang=de" });
  const window = await openWindow(page, "open");
  await window.locator("textarea").fill("(0,0)\n(4,0)\n(x,4)");
  await window.getByRole("button", { name: "Öffnen" }).click();
  await window.locator(".problem").waitFor();
  assert.match(await window.locator(".problem").textContent(), /^Zeile 3/);
  await page.done();
});

test("the filter of the keys finds German words", async () => {
  const page = await browser.open({ address: "?lang=de" });
  const window = await openWindow(page, "keys");
  await window.getByRole("searchbox").fill("rückgängig");
  assert.deepEqual(await window.locator("dt:visible").allTextContents(), ["Rückgängig"]);
  await page.done();
});

test("the menu changes the language of this browser, and the work stays", async () => {
  const page = await browser.open({ locale: "de-DE" });
  assert.equal(await page.evaluate(() => document.documentElement.lang), "de");
  await load(page, asset("arrow"));
  await set(page, { teams: 4 });
  const before = await link(page);
  await press(page, "more");
  await press(page, "Deutsch"); // its name for scripts
  await page.waitForFunction(() => document.documentElement.lang === "en" && window.evenlift);
  await page.evaluate(() => evenlift.ready);
  await idle(page);
  assert.match(await summary(page), /robots/);
  assert.equal(await link(page), before);
  await page.done();
});

test("cards over the drawing have their words in German, too: a task's, a challenge's and a lesson's end", async () => {
  for (const [address, card, words] of [
    ["?lang=de&lesson=task-thirty", "#task", /Dieses Objekt wiegt 100 kg.*Die größte Last beträgt höchstens 30 kg/],
    ["?lang=de&place=4", "#challenge", /\p{L}{4,}.*\p{L}{4,}/u],
  ]) {
    const page = await browser.open({ address });
    await page.locator(card).waitFor();
    await idle(page);
    assert.match(plain(await page.locator(card).innerText()).replaceAll("\n", " "), words, card);
    assert.equal(await page.locator(`${card} .said`).first().isVisible(), true, card);
    await page.done();
  }
  const page = await browser.open({ address: "?lang=de&lesson=three-equations" });
  await page.locator("#canvas").focus();
  await page.keyboard.press("End");
  await page.locator("#lesson-end").waitFor();
  assert.match(await page.locator("#lesson-end").innerText(), /\?/);
  await page.done();
});

// --- Numbers as Germans write them ----------------------------------------------------------------------------------

const shownIn = async (page, label) => plain(await page.locator(`#mirror input[aria-label="${label}"]`).inputValue());
const plain = (text) => text.replaceAll("\u00a0", " ");

test("numbers have a decimal comma in sentences, fields and pictures, and a point in links and for scripts", async () => {
  const page = await browser.open({ address: "?lang=de" });
  assert.match(plain(await summary(page)), /16,7 kg/);
  assert.doesNotMatch(plain(await summary(page)), /\d\.\d/);
  await type(page, "com", "560,123; 250,5");
  assert.deepEqual((await state(page)).centre_of_mass, [560.123, 250.5]);
  await press(page, "com");
  assert.equal(await page.evaluate(() => document.activeElement.value), "560,123; 250,5", "to be typed over");
  await page.keyboard.press("Escape");
  await type(page, "min ratio", "0,85");
  assert.equal((await state(page)).min_ratio, 0.85);
  assert.equal(await shownIn(page, "Kleinstes Lastverhältnis"), "0,85");
  const svg = await page.evaluate(() => window.evenlift.svg());
  assert.match(plain(svg), /<text[^>]*>[^<]*\d,\d kg<|\d,\d kg/);
  assert.doesNotMatch(await fragment(page), /,5/);
  await page.done();
});

test("German 1.000 is asked about, and what is no doubt is read", async () => {
  const page = await browser.open({ address: "?lang=de" });
  for (const [typed, weight] of [
    ["1000", 1000],
    ["437,5", 437.5],
    ["437.5", 437.5],
    ["1.234,5", 1234.5],
    ["1,234.5", 1234.5],
    ["1.000.000", 1e6],
    ["1 000 kg", 1000],
    ["1,000", 1],
    ["0.125", 0.125],
  ]) {
    await type(page, "weight", typed);
    assert.equal((await state(page)).weight, weight, typed);
  }
  for (const [typed, readings] of [
    ["1.000", "1000 oder 1 "],
    ["1.500", "1500 oder 1,5 "],
  ]) {
    await type(page, "weight", typed);
    assert.match(await page.locator("#alert").textContent(), new RegExp(`^„${typed}“ kann ${readings}bedeuten`));
    await page.keyboard.press("Escape");
    await idle(page);
    assert.equal((await state(page)).weight, 0.125, typed);
  }
  await page.done();
});

test("the keys have their own names, and the experiment's numbers are typed with a comma", async () => {
  const page = await browser.open({ address: "?lang=de" });
  const keys = await openWindow(page, "keys");
  assert.match(await keys.innerText(), /Kleinstes Lastverhältnis erhöhen\s*\./);
  await page.keyboard.press("Escape");
  await allClosed(page);
  await openWindow(page, "experiment");
  const ratio = page.locator("#experiment").getByLabel("Kleinstes Lastverhältnis");
  assert.equal(await ratio.inputValue(), "0,8");
  await ratio.evaluate((field) => {
    field.value = "0,85";
    field.dispatchEvent(new Event("input"));
  });
  assert.equal(await ratio.evaluate((field) => field.validity.valid), true);
  await ratio.evaluate((field) => {
    field.value = "85";
    field.dispatchEvent(new Event("input"));
  });
  assert.equal(await ratio.evaluate((field) => field.validationMessage), "Geben Sie eine Zahl von 0 bis 1 ein.");
  await page.done();
});

test("the table of vertices shows and reads decimal commas, and keeps each digit", async () => {
  const page = await browser.open({ address: "?lang=de" });
  await load(page, "(0,0)\n(10.5,0)\n(10.123456789012,8)\n(0,8)\n");
  await openWindow(page, "table");
  const inputs = page.locator("#table tbody input");
  assert.equal(await inputs.nth(2).inputValue(), "10,5");
  await inputs.nth(4).focus();
  assert.equal(await inputs.nth(4).inputValue(), "10,123456789012");
  await inputs.nth(2).fill("11,25");
  await inputs.nth(2).press("Enter");
  await idle(page);
  assert.deepEqual((await state(page)).polygon[1], [11.25, 0]);
  assert.deepEqual((await state(page)).polygon[2], [10.123456789012, 8]);
  await page.done();
});

test("a weight keeps the name that a user gave it", async () => {
  const page = await browser.open({ address: "?lang=de" });
  await set(page, { cargo: [{ at: [400, 300], weight: 20, name: "robots" }] });
  await openWindow(page, "table");
  await page.locator("#table").getByRole("button", { name: "Gewichte", exact: true }).click();
  await idle(page);
  assert.equal(await page.locator("#table tbody input").last().inputValue(), "robots");
  assert.match(await page.evaluate(() => window.evenlift.svg()), />robots</);
  await page.done();
});
