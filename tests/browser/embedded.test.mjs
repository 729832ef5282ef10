// A figure in an article takes wheel, fingers and keys only while the reader holds it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { evenlift, idle, link, phone, sample, sharedBrowser, tap, wide } from "../page/browser.mjs";

const browser = sharedBrowser();

const shared = evenlift("link", "encode", sample("guitar")).trim();
const stepOf = (encoded) => JSON.parse(evenlift("link", "decode", encoded)).step ?? undefined;

// Opens an article longer than the window, and waits until its figure is loaded.
async function article(options = {}, address = `?embed=1#${shared}`) {
  const context = await browser.browser.newContext({ viewport: wide, colorScheme: "light", ...options });
  const lines = (count) => Array.from({ length: count }, (_, i) => `<p>Line ${i + 1}.</p>`).join("");
  const body = `<!doctype html><html lang="en"><meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="icon.svg"><title>An article</title>
    <h1 id="head">An article</h1><p><a id="before" href="#head">A link</a></p><iframe title="A figure" src="index.html${address}" width="100%" height="360"></iframe>${lines(80)}</html>`;
  await context.route("**/article.html", (route) => route.fulfill({ contentType: "text/html", body }));
  const page = await browser.open({ context, address: "article.html", ready: false });
  const frame = await (await page.locator("iframe").elementHandle()).contentFrame();
  await frame.waitForFunction(() => globalThis.evenlift);
  await frame.evaluate(() => evenlift.ready);
  await idle(frame);
  return {
    page,
    frame,
    // A point in an empty corner of the figure, wherever the article is.
    ground: async () => {
      const { x, y } = await page.locator("iframe").boundingBox();
      return [x + 24, y + 90];
    },
    done: async () => {
      await page.done();
      await context.close();
    },
  };
}

const scrolled = (page) => page.evaluate(() => scrollY);
// The scale and place of the figure's object.
const seen = (frame) => frame.evaluate(() => [...evenlift.view.to_screen(0, 0), ...evenlift.view.to_screen(100, 0)]);
const isHeld = (frame) => frame.evaluate(() => !document.documentElement.classList.contains("guest"));
const held = (frame, on) =>
  frame.waitForFunction((wanted) => document.documentElement.classList.contains("guest") !== wanted, on);

// Two frames were drawn without more scrolling.
async function atRest(page) {
  await page.evaluate(async () => {
    const picture = () => new Promise((done) => requestAnimationFrame(done));
    for (let last, still = 0; still < 3; last = scrollY) {
      await picture();
      still = last === scrollY ? still + 1 : 0;
    }
  });
}

async function back(page) {
  await page.evaluate(() => scrollTo(0, 0));
  await atRest(page);
}

// Returns whether turning the wheel over the figure moved the article, or else the figure's view.
async function wheel({ page, frame, ground }) {
  await page.mouse.move(...(await ground()));
  const before = JSON.stringify(await seen(frame)),
    from = await scrolled(page);
  await page.mouse.wheel(0, 120);
  const [movedArticle, movedFigure] = await moved(page, frame, from, before);
  assert.notEqual(movedArticle, movedFigure, `article ${movedArticle}, figure ${movedFigure}`);
  return movedArticle ? "article" : "figure";
}

// Waits until one of the two has moved, then until both are at rest.
async function moved(page, frame, from, before) {
  await page.waitForFunction(
    ([top, view]) => {
      const { to_screen: at } = frames[0].evenlift.view;
      return scrollY !== top || JSON.stringify([...at(0, 0), ...at(100, 0)]) !== view;
    },
    [from, before],
  );
  await atRest(page);
  await idle(frame);
  return [(await scrolled(page)) !== from, JSON.stringify(await seen(frame)) !== before];
}

test("the wheel scrolls the article over an untouched figure, and the figure once it was clicked, until the reader clicks elsewhere or presses Esc", async () => {
  const opened = await article();
  const { page, frame, ground } = opened;
  assert.equal(await isHeld(frame), false);
  assert.equal(await wheel(opened), "article");
  await back(page);
  await page.mouse.click(...(await ground()));
  await held(frame, true);
  assert.equal(await wheel(opened), "figure");
  assert.equal(await scrolled(page), 0);

  const { x, y } = await page.locator("h1").boundingBox();
  await page.mouse.click(x + 4, y + 4);
  await held(frame, false);
  assert.equal(await wheel(opened), "article");
  await back(page);

  await page.mouse.click(...(await ground()));
  await held(frame, true);
  assert.equal(await wheel(opened), "figure", "a second time, too");
  await page.keyboard.press("Escape");
  await held(frame, false);
  assert.equal(await wheel(opened), "article");
  await opened.done();
});

test("Tab takes hold of a figure, keys are its own then, and Tab leaves it", async () => {
  const opened = await article({}, "?embed=1&lesson=moved");
  const { page, frame } = opened;
  await page.locator("#before").focus();
  const first = await link(frame);
  await page.keyboard.press("Tab");
  await held(frame, true);
  await page.keyboard.press("ArrowRight");
  await idle(frame);
  assert.notEqual(stepOf(await link(frame)), stepOf(first));
  assert.equal(await wheel(opened), "figure");
  await page.keyboard.press("Shift+Tab");
  await held(frame, false);
  assert.equal(await page.evaluate(() => document.activeElement.id), "before");
  assert.equal(await wheel(opened), "article");
  await back(page);
  // After Esc, the figure keeps the focus but takes no key from the article.
  await page.keyboard.press("Tab");
  await held(frame, true);
  await page.keyboard.press("Escape");
  await held(frame, false);
  const then = await link(frame);
  const passed = await frame.evaluate(() => {
    const event = new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, cancelable: true });
    return document.body.dispatchEvent(event);
  });
  await idle(frame);
  assert.ok(passed, "the browser may do with the key what it does");
  assert.equal(await link(frame), then);
  await opened.done();
});

test("Ctrl and the wheel, which a trackpad's pinch is, are the browser's over an untouched figure", async () => {
  const { frame, done } = await article();
  const turn = () =>
    frame.evaluate(() =>
      document
        .getElementById("canvas")
        .dispatchEvent(
          new WheelEvent("wheel", {
            deltaY: 40,
            ctrlKey: true,
            clientX: 100,
            clientY: 100,
            bubbles: true,
            cancelable: true,
          }),
        ),
    );
  const before = await seen(frame);
  assert.ok(await turn(), "it is not kept from the browser");
  await idle(frame);
  assert.deepEqual(await seen(frame), before);
  await frame.locator("#canvas").focus();
  await held(frame, true);
  assert.equal(await turn(), false);
  await idle(frame);
  assert.notDeepEqual(await seen(frame), before);
  await done();
});

const byFinger = { viewport: phone, hasTouch: true, isMobile: true };

test("a swipe over an untouched figure scrolls the article; after a tap it moves the figure's view, until a tap elsewhere", async () => {
  const opened = await article(byFinger);
  const { page, frame, ground } = opened;
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  // Returns what an upward swipe moved.
  const swipe = async () => {
    const [x, y] = await ground();
    const before = JSON.stringify(await seen(frame)),
      from = await scrolled(page);
    await touch("touchStart", [x, y + 180]);
    for (let i = 1; i <= 10; ++i) await touch("touchMove", [x, y + 180 - 14 * i]);
    await touch("touchEnd");
    const [movedArticle, movedFigure] = await moved(page, frame, from, before);
    assert.notEqual(movedArticle, movedFigure, `article ${movedArticle}, figure ${movedFigure}`);
    return movedArticle ? "article" : "figure";
  };
  const polygon = await frame.evaluate(() => evenlift.state().polygon);
  assert.equal(await swipe(), "article");
  assert.equal(await isHeld(frame), false, "a swipe does not take hold");
  await back(page);
  await page.touchscreen.tap(...(await ground()));
  await held(frame, true);
  assert.equal(await swipe(), "figure");
  assert.equal(await scrolled(page), 0);
  const { x, y } = await page.locator("h1").boundingBox();
  await page.touchscreen.tap(x + 8, y + 8);
  await held(frame, false);
  assert.equal(await swipe(), "article");
  assert.deepEqual(await frame.evaluate(() => evenlift.state().polygon), polygon, "none of that edited it");
  await opened.done();
});

test("the tap that takes hold is the control's, too, and is one tap", async () => {
  const page = await browser.open({ address: "?embed=1&lesson=opposite", ...byFinger });
  await idle(page);
  assert.equal(await isHeld(page), false);
  const before = stepOf(await link(page));
  await page.evaluate(() => {
    globalThis.mouse = [];
    for (const type of ["mousedown", "click"])
      addEventListener(type, () => globalThis.mouse.push(type), { capture: true });
  });
  await tap(page, "Next step");
  await idle(page);
  assert.equal(await isHeld(page), true);
  const next = stepOf(await link(page));
  assert.ok(next > before, `${before}, ${next}`);
  assert.deepEqual(await page.evaluate(() => globalThis.mouse), [], "it does not come once more as a mouse's");
  await tap(page, "Previous step");
  await idle(page);
  assert.equal(stepOf(await link(page)), before);
  await page.done();
});

test("two fingers on an untouched figure are the article's, too", async () => {
  const page = await browser.open({ address: `?embed=1#${shared}`, ...byFinger });
  await idle(page);
  const before = await seen(page);
  const allowed = await page.evaluate(() => {
    const canvas = document.getElementById("canvas");
    const touches = [
      [100, 200],
      [200, 200],
    ].map(([clientX, clientY], identifier) => new Touch({ identifier, target: canvas, clientX, clientY }));
    const send = (type, all, changed) =>
      canvas.dispatchEvent(
        new TouchEvent(type, {
          touches: all,
          targetTouches: all,
          changedTouches: changed,
          bubbles: true,
          cancelable: true,
        }),
      );
    const [one, two] = touches;
    const wider = [one, new Touch({ identifier: 1, target: canvas, clientX: 300, clientY: 200 })];
    return [
      send("touchstart", [one], [one]),
      send("touchstart", touches, [two]),
      send("touchmove", wider, [wider[1]]),
      send("touchend", [one], [wider[1]]),
      send("touchend", [], [one]),
    ];
  });
  assert.deepEqual(allowed, [true, true, true, true, true], "none is kept from the browser");
  await idle(page);
  assert.deepEqual(await seen(page), before);
  assert.equal(await isHeld(page), false);
  await page.done();
});

test("the page proper is no guest: its fingers and its wheel are the drawing's at once", async () => {
  const page = await browser.open(byFinger);
  assert.equal(await page.evaluate(() => getComputedStyle(document.getElementById("canvas")).touchAction), "none");
  assert.equal(await page.evaluate(() => getComputedStyle(document.documentElement).overscrollBehaviorY), "none");
  assert.equal(await isHeld(page), true);
  await page.done();
});
