import assert from "node:assert/strict";
import { test } from "node:test";
import { asset, idle, link, load, phone, sharedBrowser } from "../page/browser.mjs";
import { allClosed, openWindow, violations } from "../page/windows.mjs";

const names = ["samples", "open", "save", "table", "lessons", "experiment", "keys", "about", "glossary"];
const finger = { viewport: phone, hasTouch: true, isMobile: true };

const browser = sharedBrowser();

for (const [how, options] of [
  ["light", {}],
  ["dark", { colorScheme: "dark" }],
  ["on a phone", finger],
]) {
  test(`no window has a fault that axe finds, ${how}`, async () => {
    const page = await browser.open({ ...options, reducedMotion: "reduce" });
    assert.deepEqual(await violations(page), [], "without a window");
    for (const name of names) {
      const window = await openWindow(page, name);
      assert.deepEqual(await violations(page), [], name);
      if (name === "open") {
        await window.getByRole("button", { name: "Open" }).click();
        assert.deepEqual(await violations(page), [], "with a problem");
      }
      if (name === "save") {
        await window.getByRole("button", { name: "QR code" }).click();
        await page.locator("#qr").waitFor();
        assert.deepEqual(await violations(page), [], "QR code");
        await page.keyboard.press("Escape");
      }
      await page.keyboard.press("Escape");
      await allClosed(page);
    }
    await page.done();
  });
}

test("Tab stays in a modal window, keys do not reach the canvas, Escape gives the focus back", async () => {
  const page = await browser.open();
  await load(page, asset("arrow"));
  const before = await link(page);
  for (const name of ["samples", "open", "save", "lessons"]) {
    await openWindow(page, name);
    for (let i = 0; i < 14; ++i) {
      await page.keyboard.press("Tab");
      const inside = await page.evaluate(
        () => document.activeElement === document.body || document.activeElement.closest("dialog") !== null,
      );
      assert.ok(inside, name);
    }
    await page.evaluate(() => document.activeElement.blur());
    for (const key of ["t", "m", "h", "Delete", "Control+z", "?"]) await page.keyboard.press(key);
    assert.equal(await link(page), before, name);
    await page.keyboard.press("Escape");
    await allClosed(page);
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas", name);
  }
  await page.done();
});

test("nothing moves for those who asked for less motion", async () => {
  const page = await browser.open({ reducedMotion: "reduce" });
  for (const name of names) {
    const window = await openWindow(page, name);
    assert.equal(await window.evaluate((root) => root.getAnimations({ subtree: true }).length), 0, name);
    await page.keyboard.press("Escape");
    await allClosed(page);
  }
  await page.done();
});

test("pressed twice, a window opens once; a modal one is not opened over another", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  for (const key of ["s", "s", "o"]) await page.keyboard.press(key);
  await page.locator("dialog").first().waitFor();
  await idle(page);
  assert.equal(await page.locator("dialog").count(), 1);
  await page.done();
});

test("they fit small screens: they begin at their beginning, nothing is cut off, targets are for fingers", async () => {
  for (const viewport of [
    { width: 320, height: 568 },
    { width: 740, height: 360 },
    { width: 844, height: 390 },
  ]) {
    const page = await browser.open({ ...finger, viewport });
    for (const name of names) {
      const window = await openWindow(page, name);
      const { x, y, width, height } = await window.boundingBox();
      assert.ok(
        x >= 0 && y >= -1 && x + width <= viewport.width && y + height <= viewport.height + 1,
        `${name}: ${[x, y, width, height]}`,
      );
      assert.ok(
        await window.evaluate((root) =>
          [...root.querySelectorAll("*")].every(
            (e) =>
              e.closest(".for-readers, svg, .acts, .qr") ||
              (e.getBoundingClientRect().right <= innerWidth + 0.5 && e.getBoundingClientRect().left >= -0.5),
          ),
        ),
        name,
      );
      assert.ok(
        await window.evaluate((root) =>
          [root, ...root.querySelectorAll("*")].every(({ scrollTop }) => scrollTop === 0),
        ),
        `${name} begins at its beginning`,
      );
      // Text has at least half of a window's height, whatever buttons are at its foot.
      const words = await window.evaluate((root) => {
        const { top, bottom } = (root.querySelector(".scroll") ?? root).getBoundingClientRect();
        return Math.min(bottom, innerHeight) - top;
      });
      assert.ok(["table", "open"].includes(name) || words >= height / 2, `${name}: ${words} of ${height}`);
      const smallest = await window
        .locator("button:visible")
        .evaluateAll((all) => Math.min(...all.map((b) => b.getBoundingClientRect().height)));
      assert.ok(smallest >= 44, `${name}: ${smallest}`);
      await page.keyboard.press("Escape");
      await page.evaluate(() => document.querySelector("dialog")?.close());
      await allClosed(page);
    }
    await page.done();
  }
});

test("in a frame the list of keys has only those that work there", async () => {
  const page = await browser.open({ address: "?embed=1" });
  await page.locator("#canvas").focus();
  await page.keyboard.press("?");
  const list = page.locator("#keys .key-groups");
  await list.waitFor();
  assert.deepEqual(await list.locator("h3").allTextContents(), ["What is shown", "Lesson", "Help"]);
  assert.doesNotMatch(await list.textContent(), /Samples|Undo|About|Fold/);
  await page.done();
});
