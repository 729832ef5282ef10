// By pointer, by typed lengths and angles, and by keys alone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { control, drag, idle, phone, press, sharedBrowser, state, tap } from "./browser.mjs";

const browser = sharedBrowser();

async function drawing(...corners) {
  const page = await browser.open();
  await idle(page);
  await page.keyboard.press("d");
  for (const at of corners) await page.mouse.click(...at);
  await idle(page);
  return page;
}

const near = (a, b, within = 1.5) => Math.hypot(a[0] - b[0], a[1] - b[1]) <= within;
const toWorld = (page, at) => page.evaluate((p) => evenlift.view.to_world(...p), at);
const news = (page) => page.evaluate(() => document.getElementById("news").textContent);

test("a placed vertex is dragged before the shape is closed, and the view stays", async () => {
  const page = await drawing([220, 200], [560, 190], [640, 420]);
  const wanted = await toWorld(page, [600, 250]);
  await drag(page, [560, 190], [600, 250]);
  assert.deepEqual(await toWorld(page, [600, 250]), wanted, "nothing panned");
  await page.mouse.click(220, 200);
  await idle(page);
  const { polygon } = await state(page);
  assert.equal(polygon.length, 3);
  assert.ok(near(polygon[1], wanted), JSON.stringify(polygon));
  await page.done();
});

test("a press on a placed vertex places none", async () => {
  const page = await drawing([220, 200], [560, 190], [640, 420], [400, 610]);
  await page.mouse.click(561, 191);
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).polygon.length, 4);
  await page.done();
});

test("the first key of a drawing shows the cursor, also Enter, and a sentence says what keys do", async () => {
  const page = await browser.open();
  await idle(page);
  await page.keyboard.press("d");
  await page.waitForFunction(() =>
    /arrow keys move a cursor, and Enter places a vertex/.test(document.getElementById("news").textContent),
  );
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => /^Cursor at /.test(document.getElementById("news").textContent));
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => /^Vertex 1 at/.test(document.getElementById("news").textContent));
  await page.done();
});

test("a shape is drawn by keys alone, and what happens is told", async () => {
  const page = await browser.open();
  await idle(page);
  await page.keyboard.press("d");
  await page.keyboard.press("ArrowRight"); // shows the cursor
  await page.keyboard.press("Enter");
  for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => /Cursor at .*long · 0\.0°/.test(document.getElementById("news").textContent));
  await page.keyboard.press(" ");
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press(" ");
  await page.keyboard.press("Backspace");
  await page.waitForFunction(() => /Vertex 3 at/.test(document.getElementById("news").textContent));
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowLeft");
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowDown");
  await page.waitForFunction(() => /Enter closes the shape/.test(document.getElementById("news").textContent));
  await page.keyboard.press("Enter");
  await idle(page);
  const { polygon } = await state(page);
  assert.equal(polygon.length, 3);
  const step = (polygon[1][0] - polygon[0][0]) / 5;
  assert.ok(step > 0);
  assert.ok(Math.abs(polygon[2][1] - polygon[1][1] - 4 * step) < 1e-9, "dots of the grid");
  await page.done();
});

test("the length and the angle of an edge are typed", async () => {
  const page = await drawing([300, 300]);
  const field = (label) => page.locator("#mirror").getByRole("textbox", { name: label, exact: true });
  const edge = async (length, angle) => {
    await field("Length").fill(length);
    await field("Angle").focus();
    await field("Angle").fill(angle);
    await page.keyboard.press("Enter");
    await idle(page);
  };
  await edge("120", "0");
  await edge("50", "90");
  await edge("12,5", "180°");
  await field("Length").fill("many");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => /not a number/.test(document.getElementById("alert").textContent));
  await page.locator("#canvas").focus();
  await press(page, "Close the shape");
  await idle(page);
  const {
    polygon: [a, b, c, d],
  } = await state(page);
  const along = (p, q) => [q[0] - p[0], q[1] - p[1]];
  assert.ok(near(along(a, b), [120, 0], 1e-4), JSON.stringify([a, b]));
  assert.ok(near(along(b, c), [0, 50], 1e-4), JSON.stringify([b, c]));
  assert.ok(near(along(c, d), [-12.5, 0], 1e-4), JSON.stringify([c, d]));
  await page.done();
});

test("digits typed on the drawing are the length of the next edge, which is shown at once; Enter leads to the next length", async () => {
  const page = await drawing([300, 300], [500, 320]);
  const focus = () =>
    page.evaluate(() => [document.activeElement.getAttribute("aria-label"), document.activeElement.value]);
  const told = (words) =>
    page.waitForFunction((text) => document.getElementById("news").textContent.includes(text), words);
  await page.keyboard.type("120");
  assert.deepEqual(await focus(), ["Length", "120"]);
  await page.keyboard.press("Tab");
  await page.keyboard.type("90");
  await told("120 long · 90.0°");
  await page.keyboard.press("Escape");
  await idle(page);
  assert.match(await news(page), /^Vertex 2 at/, "what was typed is taken back");
  await page.keyboard.type("120");
  await page.keyboard.press("Tab");
  await page.keyboard.type("90");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement.getAttribute("aria-label") === "Length");
  await page.keyboard.type("5");
  await told("5 long");
  await page.keyboard.press("Escape");
  await idle(page);
  await page.keyboard.press("Enter");
  await idle(page);
  const { polygon } = await state(page);
  assert.equal(polygon.length, 3);
  assert.ok(
    near([polygon[2][0] - polygon[1][0], polygon[2][1] - polygon[1][1]], [0, 120], 1e-4),
    JSON.stringify(polygon),
  );
  await page.done();
});

test("a length below 1 is typed on the drawing like any other, and Enter where nothing was typed closes the shape", async () => {
  const page = await drawing([300, 300]);
  const { min_ratio: ratio } = await state(page);
  const edge = async (length, angle) => {
    await page.keyboard.type(length);
    await page.keyboard.press("Tab");
    await page.keyboard.type(angle);
    await page.keyboard.press("Enter");
  };
  await edge("0.5", "0");
  await edge(".5", "90");
  await edge("0,5", "180");
  await page.keyboard.press("Enter");
  await idle(page);
  const after = await state(page);
  assert.equal(after.min_ratio, ratio);
  assert.equal(after.polygon.length, 4);
  const [a, b, c, d] = after.polygon;
  assert.ok(near([b[0] - a[0], b[1] - a[1]], [0.5, 0], 1e-6), JSON.stringify([a, b]));
  assert.ok(near([c[0] - b[0], c[1] - b[1]], [0, 0.5], 1e-6), JSON.stringify([b, c]));
  assert.ok(near([d[0] - c[0], d[1] - c[1]], [-0.5, 0], 1e-6), JSON.stringify([c, d]));
  await page.done();
});

test("in a small window, too, the bar of drawing has all of its buttons and fields in sight", async () => {
  const page = await browser.open({ viewport: { width: 640, height: 400 } });
  await idle(page);
  await page.keyboard.press("d");
  await page.mouse.click(100, 300);
  await idle(page);
  for (const name of ["Close", "Back", "Cancel", "edge length", "edge angle"]) {
    const { x, y, width, height } = await control(page, name);
    assert.ok(x >= 0 && y >= 0 && x + width <= 290 && y + height < 250, `${name}: ${[x, y, width, height]}`);
  }
  await page.done();
});

test("on a phone, too, the length and the angle of an edge are typed", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  await tap(page, "Draw");
  await idle(page);
  for (const at of [
    [100, 300],
    [300, 320],
  ])
    await page.touchscreen.tap(...at);
  await idle(page);
  await tap(page, "edge length");
  await page.keyboard.type("50");
  await tap(page, "edge angle");
  await page.keyboard.type("90");
  await page.keyboard.press("Enter");
  await idle(page);
  await tap(page, "Close the shape");
  await idle(page);
  const {
    polygon: [, b, c],
  } = await state(page);
  assert.ok(near([c[0] - b[0], c[1] - b[1]], [0, 50], 1e-4), JSON.stringify([b, c]));
  await control(page, "teams +");
  await page.done();
});

test("under a finger the fields of the next edge are empty until something is typed", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  await tap(page, "Draw");
  const shown = async () => {
    await idle(page);
    return page
      .locator("#mirror")
      .getByRole("textbox", { name: /^(Length|Angle)$/ })
      .evaluateAll((fields) => fields.map((field) => field.value));
  };
  await idle(page);
  await page.touchscreen.tap(100, 300);
  assert.deepEqual(await shown(), ["–", "–"]);
  await page.touchscreen.tap(300, 320);
  assert.deepEqual(await shown(), ["–", "–"]);
  await tap(page, "edge length");
  assert.equal(await page.evaluate(() => document.activeElement.value), "");
  await page.keyboard.type("50");
  await page.keyboard.press("Enter");
  await page.touchscreen.tap(200, 200);
  assert.deepEqual(await shown(), ["–", "–"], "the edge does not lead back to where the last one was typed");
  await page.done();
});

test("Escape in a field of the edge takes back what was typed there, and no vertex", async () => {
  const page = await drawing([300, 300], [500, 320]);
  const length = page.locator("#mirror").getByRole("textbox", { name: "Length", exact: true });
  const shown = await length.inputValue();
  await length.fill("99");
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
  assert.equal(await length.inputValue(), shown);
  assert.match(await news(page), /^Vertex 2 at/);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.match(await news(page), /^Vertex 1 at/);
  await page.done();
});

test("Draw and Move say that they are on, and snapping says so, too", async () => {
  const page = await browser.open();
  await idle(page);
  const toggle = (name) => page.locator(`#mirror [aria-pressed][aria-label^="${name}"]`).first();
  for (const [key, name] of [
    ["d", "Draw"],
    ["w", "Move, turn or scale the shape"],
  ]) {
    await toggle(name).waitFor({ state: "attached" });
    assert.equal(await toggle(name).getAttribute("aria-pressed"), "false");
    await page.keyboard.press(key);
    await idle(page);
    assert.equal(await toggle(name).getAttribute("aria-pressed"), "true");
    await page.keyboard.press("Escape");
    await idle(page);
  }
  await page.keyboard.press("n");
  await page.waitForFunction(() => /snap to the grid/.test(document.getElementById("alert").textContent));
  await page.done();
});
