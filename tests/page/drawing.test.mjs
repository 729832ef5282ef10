// Pointer, touch and keys.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  control,
  drag,
  fragment,
  idle,
  load,
  openL,
  phone,
  press,
  published,
  set,
  sharedBrowser,
  state,
  toScreen,
} from "./browser.mjs";

const browser = sharedBrowser();

const opened = (options) => openL(browser, options);

test("dragging the centre of mass changes the result and the link", async () => {
  const page = await opened();
  const before = await state(page);
  await published(page);
  const link = await fragment(page);
  const [x, y] = await toScreen(page, before.centre_of_mass);
  await drag(page, [x, y], [x + 30, y + 20]);
  const now = await state(page);
  const [wx, wy] = await page.evaluate((p) => evenlift.view.to_world(...p), [x + 30, y + 20]);
  assert.ok(Math.hypot(now.centre_of_mass[0] - wx, now.centre_of_mass[1] - wy) < 2);
  assert.notDeepEqual(now.teams, before.teams);
  await published(page);
  assert.notEqual(await fragment(page), link);
  await page.done();
});

test("dragging a vertex moves that vertex, everything follows, and one undo takes it back", async () => {
  const page = await opened();
  const before = await state(page);
  const [x, y] = await toScreen(page, [400, 150]);
  await drag(page, [x + 3, y - 2], [x + 63, y - 42], 12);
  const now = await state(page);
  const [wx, wy] = await page.evaluate((p) => evenlift.view.to_world(...p), [x + 60, y - 40]);
  assert.ok(Math.hypot(now.polygon[2][0] - wx, now.polygon[2][1] - wy) < 2, "it keeps its distance to the pointer");
  assert.deepEqual(
    now.polygon.filter((_, i) => i !== 2),
    before.polygon.filter((_, i) => i !== 2),
  );
  assert.notEqual(now.coverage, before.coverage);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.deepEqual(await state(page), before);
  await page.keyboard.press("Control+Shift+z");
  await idle(page);
  assert.deepEqual(await state(page), now);
  await page.done();
});

test("what is dragged gets numbers that a person can read", async () => {
  const page = await opened();
  const [x, y] = await toScreen(page, [0, 0]);
  await drag(page, [x, y], [x - 31, y + 17]);
  const { polygon } = await state(page);
  for (const c of polygon[0]) assert.ok(String(c).length <= 6, String(c));
  await page.done();
});

test("a polygon made invalid says why, keeps the last result, and can be put right", async () => {
  const page = await opened();
  const [x, y] = await toScreen(page, [400, 150]);
  const [bx, by] = await toScreen(page, [75, 350]);
  await drag(page, [x, y], [bx, by]);
  await page.waitForFunction(() => /cross/i.test(document.getElementById("summary").textContent));
  const kept = await state(page);
  assert.equal(kept.polygon.length, 6);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => /robots/.test(document.getElementById("summary").textContent));
  assert.deepEqual((await state(page)).polygon[2], [400, 150]);
  await page.done();
});

test("a double-click on an edge adds a vertex, Delete removes it", async () => {
  const page = await opened();
  const [x, y] = await toScreen(page, [200, 0]);
  await page.mouse.dblclick(x, y);
  await idle(page);
  const { polygon } = await state(page);
  assert.equal(polygon.length, 7);
  assert.ok(Math.hypot(polygon[1][0] - 200, polygon[1][1]) < 2);
  await page.keyboard.press("Delete");
  await idle(page);
  assert.equal((await state(page)).polygon.length, 6);
  await page.done();
});

test("a click and a short shake move nothing", async () => {
  const page = await opened();
  const before = await state(page);
  const [x, y] = await toScreen(page, [400, 150]);
  await drag(page, [x, y], [x + 2, y]);
  await page.mouse.click(640, 760);
  await idle(page);
  assert.deepEqual(await state(page), before);
  await page.done();
});

test("quick presses between two frames are not lost", async () => {
  const page = await opened();
  const [x, y] = await toScreen(page, [400, 150]);
  // In one task, so that no frame is drawn before the last.
  await page.evaluate(
    ([fromX, fromY]) => {
      const canvas = document.getElementById("canvas");
      const send = (type, cx, cy) =>
        (type === "mouseup" ? document : canvas).dispatchEvent(
          new MouseEvent(type, { clientX: cx, clientY: cy, button: 0, bubbles: true }),
        );
      send("mousemove", fromX, fromY);
      send("mousedown", fromX, fromY);
      for (let i = 1; i <= 5; ++i) send("mousemove", fromX + 10 * i, fromY);
      send("mouseup", fromX + 50, fromY);
      send("mousemove", 20, 400);
    },
    [x, y],
  );
  await idle(page);
  const [wx] = await page.evaluate((p) => evenlift.view.to_world(...p), [x + 50, y]);
  assert.ok(Math.abs((await state(page)).polygon[2][0] - wx) < 2);
  await page.done();
});

test("keys that the page does not use stay the browser's", async () => {
  const page = await opened();
  await page.evaluate(() => {
    globalThis.prevented = {};
    addEventListener(
      "keydown",
      (event) => {
        globalThis.prevented[event.key] = event.defaultPrevented;
      },
      { capture: true },
    );
    // The page's own listener came first and stops the event, so check afterwards.
    const own = Event.prototype.preventDefault;
    Event.prototype.preventDefault = function () {
      globalThis.prevented[this.key ?? this.type] = true;
      return own.call(this);
    };
  });
  await page.locator("#canvas").focus();
  for (const key of [
    "F5",
    "F11",
    "F12",
    "Tab",
    "Control+f",
    "Control+s",
    "Control+t",
    "Control+r",
    "Alt+ArrowLeft",
    "PageDown",
    "q",
    "Control+Shift+i",
  ]) {
    const last = key.split("+").at(-1);
    // Dispatched, not pressed: the browser would act on some.
    const prevented = await page.evaluate(
      ([full, name]) => {
        const event = new KeyboardEvent("keydown", {
          key: name,
          bubbles: true,
          cancelable: true,
          ctrlKey: full.includes("Control"),
          altKey: full.includes("Alt"),
          shiftKey: full.includes("Shift"),
        });
        document.getElementById("canvas").dispatchEvent(event);
        return event.defaultPrevented;
      },
      [key, last],
    );
    assert.equal(prevented, false, key);
  }
  const used = await page.evaluate(() => {
    const event = new KeyboardEvent("keydown", { key: "t", bubbles: true, cancelable: true });
    document.getElementById("canvas").dispatchEvent(event);
    return [event.defaultPrevented, evenlift.state().requested_teams];
  });
  assert.deepEqual(used, [true, 4]);
  await page.done();
});

test("the panel's controls work", async () => {
  const page = await opened();
  const before = await state(page);
  await press(page, "teams +");
  assert.equal((await state(page)).requested_teams, before.requested_teams + 1);
  await press(page, "teams -");
  await press(page, "weight +");
  assert.deepEqual([(await state(page)).requested_teams, (await state(page)).weight], [before.requested_teams, 110]);
  const { x, y, width, height } = await control(page, "ratio");
  await drag(page, [x + width / 2, y + height / 2], [x + width - 1, y + height / 2]);
  assert.equal((await state(page)).min_ratio, 1);
  const shown = await page.evaluate(() => evenlift.link());
  await press(page, "Chords");
  assert.notEqual(await page.evaluate(() => evenlift.link()), shown);
  await press(page, "Chords");
  assert.equal(await page.evaluate(() => evenlift.link()), shown);
  assert.equal(await page.evaluate(() => evenlift.view.control("no such control")), null);
  await page.done();
});

test("a finger drags a vertex from farther off, two fingers zoom", async () => {
  const page = await opened({ viewport: phone, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const [x, y] = await toScreen(page, [400, 0]);
  await touch("touchStart", [x + 14, y - 13]);
  for (let i = 1; i <= 5; ++i) await touch("touchMove", [x + 14 - 6 * i, y - 13]);
  await touch("touchEnd");
  await idle(page);
  const [wx] = await page.evaluate((p) => evenlift.view.to_world(...p), [x - 30, y]);
  assert.ok(Math.abs((await state(page)).polygon[1][0] - wx) < 3);

  const measure = () => page.evaluate(() => evenlift.view.to_screen(100, 0)[0] - evenlift.view.to_screen(0, 0)[0]);
  const before = await measure();
  const polygon = (await state(page)).polygon;
  await touch("touchStart", [150, 350]);
  await touch("touchStart", [150, 350], [250, 350]);
  for (let i = 1; i <= 5; ++i) await touch("touchMove", [150 - 10 * i, 350], [250 + 10 * i, 350]);
  await touch("touchEnd");
  await idle(page);
  assert.ok(Math.abs((await measure()) / before - 2) < 0.1);
  assert.deepEqual((await state(page)).polygon, polygon);
  await page.done();
});

// The browser counts clicks by the system's settings: two that it counts as single are no double-click, however quick.
test("two clicks that the browser does not count as a double-click are none", async () => {
  const page = await opened();
  const [x, y] = await toScreen(page, [200, 0]);
  await page.mouse.click(x, y);
  await page.mouse.click(x, y);
  assert.equal((await state(page)).polygon.length, 6);
  await page.mouse.dblclick(x, y);
  assert.equal((await state(page)).polygon.length, 7);
  await page.done();
});

// A tap's time is when it was made, not when a busy page receives it. Taps are away from robots, which a finger would
// take.
test("two taps are a double one by the time at which they were made", async () => {
  for (const [between, vertices] of [
    [200, 7],
    [900, 6],
  ]) {
    const page = await opened({ viewport: phone, hasTouch: true, isMobile: true });
    await page.evaluate(
      ([[x, y], apart]) => {
        const canvas = document.getElementById("canvas");
        for (const time of [1000, 1000 + apart]) {
          const touch = new Touch({ identifier: 1, target: canvas, clientX: x, clientY: y });
          for (const type of ["touchstart", "touchend"]) {
            const touches = type === "touchstart" ? [touch] : [];
            const event = new TouchEvent(type, {
              touches,
              targetTouches: touches,
              changedTouches: [touch],
              bubbles: true,
              cancelable: true,
            });
            Object.defineProperty(event, "timeStamp", { value: time });
            canvas.dispatchEvent(event);
          }
        }
      },
      [[...(await toScreen(page, [90, 0]))], between],
    );
    assert.equal((await state(page)).polygon.length, vertices, `${between} ms apart`);
    await page.done();
  }
});

test("large polygons open and stay usable", async () => {
  const page = await opened();
  const points = Array.from({ length: 3000 }, (_, i) => {
    const a = (2 * Math.PI * i) / 3000,
      r = 1000 + 40 * Math.sin(9 * a);
    return `(${Math.round(100 * r * Math.cos(a)) / 100},${Math.round(100 * r * Math.sin(a)) / 100})`;
  });
  await load(page, points.join("\n"));
  await idle(page);
  assert.equal((await state(page)).polygon.length, 3000);
  await set(page, { teams: 6 });
  assert.equal((await state(page)).teams.length, 6);
  await load(page, asset("labyrinth"));
  assert.notEqual((await state(page)).polygon.length, 3000);
  await page.done();
});

test("a shape half drawn is still there after a reload", async () => {
  const page = await opened();
  await page.keyboard.press("d");
  for (const at of [
    [220, 200],
    [560, 190],
    [640, 420],
  ])
    await page.mouse.click(...at);
  const said = () =>
    page.waitForFunction(() => document.getElementById("summary").textContent.startsWith("3 vertices so far"));
  await said();
  await page.waitForFunction(() => localStorage.getItem("evenlift.drawing")?.trim().split("\n").length === 3);
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  await said();
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).polygon.length, 3);
  await page.done();
});
