// The page's windows in German, and the choice of language.
import assert from "node:assert/strict";
import { test } from "node:test";
import { asset, idle, link, load, phone, press, set, sharedBrowser, summary } from "../page/browser.mjs";
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
