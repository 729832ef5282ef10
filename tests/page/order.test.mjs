// Clicks, drags, keys and calls take effect in their order, however long frames take.
import assert from "node:assert/strict";
import { test } from "node:test";
import { idle, load, openL, set, sharedBrowser, state, toScreen } from "./browser.mjs";
import { coast } from "../shapes/coast.mjs";

const browser = sharedBrowser();

const corners = [
  [220, 200],
  [560, 190],
  [640, 420],
  [400, 610],
  [190, 470],
];

// Half a second each, as on a slow machine with a large polygon.
function slowFrames() {
  const own = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (callback) =>
    own((now) => {
      callback(now);
      const until = performance.now() + 500;
      while (performance.now() < until);
    });
}

const opened = (options) => openL(browser, options);

// Browser events in one task, without a frame in between. Each is [what, ...]: a key, a place to click, a drag from
// place to place, or a script's setting.
function act(page, actions) {
  return page.evaluate((all) => {
    const canvas = document.getElementById("canvas");
    const send = (type, [clientX, clientY]) =>
      (type === "mouseup" ? document : canvas).dispatchEvent(
        new MouseEvent(type, { clientX, clientY, button: 0, detail: 1, bubbles: true, cancelable: true }),
      );
    const acts = {
      key: (key, ctrlKey = false) =>
        canvas.dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey, bubbles: true, cancelable: true })),
      click: (at) => ["mousemove", "mousedown", "mouseup"].forEach((type) => send(type, at)),
      drag(from, to) {
        send("mousemove", from);
        send("mousedown", from);
        send("mousemove", to);
        send("mouseup", to);
      },
      wheel: (at, deltaY) => {
        send("mousemove", at);
        canvas.dispatchEvent(
          new WheelEvent("wheel", { clientX: at[0], clientY: at[1], deltaY, bubbles: true, cancelable: true }),
        );
      },
      set: (changes) => evenlift.set(changes),
    };
    for (const [what, ...how] of all) acts[what](...how);
  }, actions);
}

const worldOf = (page, places) => page.evaluate((all) => all.map((p) => [...evenlift.view.to_world(...p)]), places);

function near(polygon, expected) {
  assert.equal(polygon.length, expected.length);
  polygon.forEach((p, i) =>
    assert.ok(
      Math.hypot(p[0] - expected[i][0], p[1] - expected[i][1]) < 2,
      `vertex ${i + 1} is ${p}, not ${expected[i]}`,
    ),
  );
}

test("five clicks and Enter in one moment close a shape of these five vertices", async () => {
  const page = await opened();
  await act(page, [["key", "d"], ...corners.map((at) => ["click", at]), ["key", "Enter"]]);
  const drawn = (await state(page)).polygon;
  await act(page, [["key", "z", true]]); // undo restores the view in which they were placed
  await idle(page);
  near(drawn, await worldOf(page, corners));
  await page.done();
});

test("so do the browser's own clicks and keys, one behind the other, where each frame takes half a second", async () => {
  const page = await opened({ script: slowFrames });
  const expected = await worldOf(page, corners);
  await page.locator("#canvas").focus();
  // Without waiting for the page in between.
  await Promise.all([
    page.keyboard.press("d"),
    ...corners.map(([x, y]) => page.mouse.click(x, y)),
    page.keyboard.press("Enter"),
  ]);
  near((await state(page)).polygon, expected);
  await page.done();
});

test("a key is dealt with after the click before it, and before the click after it", async () => {
  const page = await opened();
  const expected = await worldOf(page, [corners[0], corners[2], corners[3]]);
  // Escape removes only the second vertex.
  await act(page, [
    ["key", "d"],
    ["click", corners[0]],
    ["click", corners[1]],
    ["key", "Escape"],
    ["click", corners[2]],
    ["click", corners[3]],
    ["key", "Enter"],
  ]);
  near((await state(page)).polygon, expected);
  await page.done();
});

test("calls of scripts take their place between drags and keys", async () => {
  const page = await opened();
  const vertex = [...(await toScreen(page, [400, 150]))];
  const there = [vertex[0] + 40, vertex[1] - 20];
  const [to] = await worldOf(page, [there]);
  await act(page, [
    ["drag", vertex, there],
    ["set", { teams: 2 }],
  ]);
  let now = await state(page);
  assert.equal(now.requested_teams, 2);
  assert.ok(Math.hypot(now.polygon[2][0] - to[0], now.polygon[2][1] - to[1]) < 2, "the drag came first");
  // Undo first reverts the call, which came last.
  await act(page, [["key", "z", true]]);
  now = await state(page);
  assert.equal(now.requested_teams, 3);
  assert.notDeepEqual(now.polygon[2], [400, 150]);
  await act(page, [["key", "z", true]]);
  assert.deepEqual((await state(page)).polygon[2], [400, 150]);
  await page.done();
});

test("what is read by a call holds all that was done before it", async () => {
  const page = await opened();
  const vertex = [...(await toScreen(page, [400, 150]))];
  const read = await page.evaluate(([x, y]) => {
    const canvas = document.getElementById("canvas");
    const send = (target, type, cx, cy) =>
      target.dispatchEvent(new MouseEvent(type, { clientX: cx, clientY: cy, button: 0, detail: 1, bubbles: true }));
    send(canvas, "mousemove", x, y);
    send(canvas, "mousedown", x, y);
    send(canvas, "mousemove", x + 30, y);
    send(document, "mouseup", x + 30, y);
    return evenlift.state().polygon[2];
  }, vertex);
  const [[wx]] = await worldOf(page, [[vertex[0] + 30, vertex[1]]]);
  assert.ok(Math.abs(read[0] - wx) < 2, String(read));
  await page.done();
});

test("a click after a key meets the panels as the key left them", async () => {
  const page = await opened();
  const { x, y, width, height } = await page.evaluate(() => evenlift.view.control("weight +"));
  const where = [x + width / 2, y + height / 2];
  // With the panel folded away, the whole background can be drawn on.
  await act(page, [
    ["key", "d"],
    ["key", "p"],
    ["click", where],
    ["click", corners[0]],
    ["click", corners[2]],
    ["key", "Enter"],
  ]);
  assert.equal((await state(page)).polygon.length, 3);
  assert.equal((await state(page)).weight, 100);
  await page.done();
});

test("the wheel turns about where the pointer was when it turned", async () => {
  const page = await opened();
  const world = await worldOf(page, [[300, 300]]);
  await act(page, [
    ["wheel", [300, 300], -300],
    ["click", [700, 500]],
  ]);
  await idle(page);
  const [x, y] = await toScreen(page, world[0]);
  assert.ok(Math.hypot(x - 300, y - 300) < 1, `${x}, ${y}`);
  await page.done();
});

test("a number that is typed at once after the key of its field is all in the field", async () => {
  const page = await opened();
  for (const [key, typed] of [
    ["y", "231"],
    ["R", "0.65"],
  ]) {
    await page.evaluate(
      ([first, rest]) => {
        const send = (name) => {
          const { activeElement: at } = document;
          const own = at.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
          // The browser's action for a key that no handler prevented.
          if (own && at instanceof HTMLInputElement && name.length === 1)
            document.execCommand("insertText", false, name);
        };
        for (const name of [first, ...rest, "Enter"]) send(name);
      },
      [key, typed],
    );
    await idle(page);
  }
  const { weight, min_ratio: ratio } = await state(page);
  assert.deepEqual([weight, ratio], [231, 0.65]);
  await page.done();
});

// The page's answer without a drag.
async function answerTo(text) {
  const page = await browser.open();
  await load(page, text);
  await set(page, { teams: 10 });
  const answer = await state(page);
  await page.done();
  return answer;
}

for (const [name, script] of [
  ["in a worker", undefined],
  ["on the page, where there are no workers", () => delete globalThis.Worker],
])
  test(`a large object that is dragged is placed meanwhile ${name}, and at the end as it lies there`, async () => {
    const page = await browser.open({ script });
    await load(page, coast(20034));
    await set(page, { teams: 10 });
    const before = await state(page);
    const [x, y] = await toScreen(page, before.polygon[5000]);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 20; ++i) await page.mouse.move(x + i, y - i / 4);
    await idle(page);
    const during = await state(page);
    assert.notDeepEqual(during.polygon, before.polygon);
    assert.equal(during.polygon.filter(([u, v], i) => [u, v].join() !== before.polygon[i].join()).length, 1);
    for (let i = 20; i <= 30; ++i) await page.mouse.move(x + i, y - i / 4);
    await page.mouse.up();
    await idle(page);
    const after = await state(page);
    assert.notDeepEqual(after.polygon, during.polygon);
    const expected = await answerTo(await page.evaluate(() => evenlift.text()));
    for (const member of ["polygon", "centre_of_mass", "teams", "coverage", "form_closure", "margin"])
      assert.deepEqual(after[member], expected[member], member);
    await page.done();
  });
