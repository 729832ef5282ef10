import assert from "node:assert/strict";
import { afterEach, test } from "node:test";
import {
  asset,
  controlIfShown,
  drag,
  evenlift,
  idle,
  load,
  lShape,
  phone,
  set,
  sharedBrowser,
  state,
  toScreen,
} from "../page/browser.mjs";
import { allClosed, closeAll, openWindow } from "../page/windows.mjs";

let page;
const browser = sharedBrowser({
  begin: async () => {
    page = await browser.open();
  },
  end: () => page.done(),
});
afterEach(() => closeAll(page));

const polygon = async () => (await state(page)).polygon;
const shown = () =>
  page
    .locator("#table tbody tr")
    .evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll("input")].map((input) => input.value)));
const field = (vertex, axis) => page.getByLabel(`Vertex ${vertex}, ${axis}`, { exact: true });
const centre = (axis) => page.getByLabel(`Centre of mass, ${axis}`, { exact: true });

async function opened() {
  await load(page, lShape);
  await idle(page);
  return openWindow(page, "table");
}

test("it shows every vertex, and what is typed moves it, undoably", async () => {
  await opened();
  assert.deepEqual(
    await shown(),
    (await polygon()).map((p) => p.map(String)),
  );
  assert.equal(await page.evaluate(() => document.activeElement.ariaLabel), "Vertex 1, x");
  await field(3, "y").fill("170.25");
  await page.keyboard.press("Enter");
  assert.deepEqual((await polygon())[2], [400, 170.25]);
  assert.equal(await page.evaluate(() => document.activeElement.ariaLabel), "Vertex 4, y", "Enter goes on");
  await field(2, "x").fill("419,5");
  await page.keyboard.press("Tab");
  assert.deepEqual((await polygon())[1], [419.5, 0], "a decimal comma is one here, too");
  await page.keyboard.press("Shift+Tab");
  await field(2, "x").fill(" 4.2e2 ");
  await page.keyboard.press("Tab");
  assert.deepEqual((await polygon())[1], [420, 0]);
  assert.equal(await field(2, "x").inputValue(), "420");
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal((await polygon())[2][1], 150);
  assert.equal(await field(3, "y").inputValue(), "150", "it follows");
  await page.keyboard.press("Control+Shift+z");
  await idle(page);
  assert.equal(await field(3, "y").inputValue(), "170.25");
});

test("numbers that are none get a sentence and change nothing", async () => {
  const window = await opened();
  const before = JSON.stringify(await state(page));
  for (const [typed, said] of [
    ["1,234", /^Vertex 1, x: “1,234” may mean 1234 or 1\.234: type one of these\.$/],
    ["2 kg", /^Vertex 1, x: “2 kg” has the unit kg, but this number has none: type the number alone\.$/],
    ["abc", /“abc” is not a number/],
    ["", /A number is missing/],
    ["1e12", /Coordinates go from/],
    ["0x10", /not a number/],
    ["Infinity", /not a number/],
  ]) {
    await field(1, "x").fill(typed);
    await page.keyboard.press("Enter");
    assert.match(await window.locator(".problem").textContent(), said);
    assert.equal(await field(1, "x").getAttribute("aria-invalid"), "true");
    assert.equal(JSON.stringify(await state(page)), before);
  }
  await page.keyboard.press("Escape"); // reverts the typed text
  assert.equal(await field(1, "x").inputValue(), "0");
  assert.equal(await window.locator(".problem").textContent(), "");
  await page.keyboard.press("Escape");
  await allClosed(page);
  assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
});

test("robots have names, which are typed and go with their robots", async () => {
  await load(page, asset("grand-piano"));
  await page.evaluate(() =>
    evenlift.set({
      supports: [
        { at: [740, 40], capacity: 60, name: "north" },
        [731, 420],
        { at: [424, 965], name: 'the "west"' },
        [0, 318],
      ],
    }),
  );
  const names = async () => (await state(page)).support_names;
  assert.deepEqual(await names(), ["north", null, 'the "west"', null]);
  const window = await openWindow(page, "table");
  await window.getByRole("button", { name: "Robots" }).click();
  const cell = (robot) => window.getByRole("textbox", { name: `Robot ${robot}, Name` });
  assert.equal(await cell(3).inputValue(), 'the "west"');
  await cell(2).fill("jack 2");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.deepEqual(await names(), ["north", "jack 2", 'the "west"', null]);
  await cell(2).fill("x".repeat(61));
  await page.keyboard.press("Enter");
  assert.match(await window.locator(".problem").textContent(), /a name of at most 60 characters/);
  await page.keyboard.press("Escape");
  await window.getByRole("button", { name: "Delete robot 1" }).click();
  await idle(page);
  assert.deepEqual(await names(), ["jack 2", 'the "west"', null]);
  await page.evaluate(() => evenlift.set({ supports: '740,40:a 731,420 424,965:"b c"' }));
  assert.deepEqual(await names(), ["a", null, "b c"]);
});

test("a refused polygon shows why, and the last good result stays", async () => {
  const window = await opened();
  const before = JSON.stringify(await state(page));
  await field(3, "x").fill("-50");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.match(await window.locator(".refusal").textContent(), /Edges/);
  assert.equal(await field(3, "x").inputValue(), "-50");
  assert.equal(JSON.stringify(await state(page)), before);
  await field(3, "x").fill("390");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal(await window.locator(".refusal").textContent(), "");
  assert.equal((await polygon())[2][0], 390);
});

test("insert after, delete, and never fewer than three", async () => {
  const window = await opened();
  await window.getByRole("button", { name: "Insert a vertex after 6" }).click();
  assert.deepEqual((await polygon())[6], [0, 150]);
  assert.equal(await page.evaluate(() => document.activeElement.ariaLabel), "Vertex 7, x");
  await window.getByRole("button", { name: "Delete vertex 7" }).click();
  assert.equal((await polygon()).length, 6);
  assert.equal(await page.evaluate(() => document.activeElement.ariaLabel), "Delete vertex 6");
  for (const vertex of [4, 4, 4]) await window.getByRole("button", { name: `Delete vertex ${vertex}` }).click();
  assert.equal((await polygon()).length, 3);
  assert.ok(await window.getByRole("button", { name: "Delete vertex 1" }).isDisabled());
  await page.keyboard.press("Control+z");
  assert.equal((await polygon()).length, 4);
});

test("the centre of mass, and back to the centroid", async () => {
  const window = await opened();
  const { centre_of_mass: centroid } = await state(page);
  const back = window.getByRole("button", { name: "Back to centroid" });
  assert.ok(await back.isDisabled());
  // 193.333…: rounded to fit, exact with the focus.
  const rounded = await centre("x").inputValue();
  assert.ok(rounded.length <= 11 && Math.abs(Number(rounded) - centroid[0]) < 1e-4, rounded);
  await centre("x").focus();
  assert.equal(Number(await centre("x").inputValue()), centroid[0]);
  await centre("y").focus();
  assert.equal(await centre("x").inputValue(), rounded);
  assert.equal(Number(await centre("y").inputValue()), centroid[1]);
  assert.ok(await back.isDisabled(), "to look at it changes nothing");
  await centre("x").fill("130");
  await page.keyboard.press("Enter");
  assert.deepEqual((await state(page)).centre_of_mass, [130, centroid[1]]);
  await idle(page);
  await back.click();
  assert.deepEqual((await state(page)).centre_of_mass, centroid);
});

test("it follows the canvas, marks what is selected there, and leaves it usable", async () => {
  await opened();
  const [x, y] = await toScreen(page, [400, 150]);
  await drag(page, [x, y], [x + 40, y + 20]);
  await idle(page);
  assert.deepEqual((await shown())[2].map(Number), (await polygon())[2]);
  assert.notEqual((await polygon())[2][0], 400);
  await page.mouse.move(x - 300, y - 300);
  await idle(page);
  assert.deepEqual(await page.locator("#table tr.selected th").allTextContents(), ["3"]);
  await page.keyboard.press("t"); // the canvas's keys
  assert.equal((await state(page)).requested_teams, 4);
  await field(5, "x").focus();
  await page.keyboard.press("t"); // not the canvas's
  assert.equal((await state(page)).requested_teams, 4);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Escape"); // nothing is selected any more
  await page.keyboard.press("Escape");
  await allClosed(page);
});

test("the key that opens it closes it", async () => {
  await opened();
  await page.locator("#canvas").focus();
  await page.keyboard.press("e");
  await allClosed(page);
});

test("as text: all of it at once, with the settings kept", async () => {
  const window = await opened();
  await set(page, { teams: 2, com: [120, 100] });
  await window.getByRole("button", { name: "Edit as text" }).click();
  const area = page.locator("#open textarea");
  assert.equal(await area.inputValue(), `CoM:(120,100)\n${lShape}`);
  await area.fill("(0,0)\n(90,0)\n(90,90)\n");
  await page.getByRole("button", { name: "Apply" }).click();
  await page.locator("#open").waitFor({ state: "detached" });
  await idle(page);
  assert.equal((await shown()).length, 3);
  assert.equal((await state(page)).requested_teams, 2);
});

test("a polygon of many vertices stays quick, in pages", async () => {
  await load(page, evenlift("generate", "convex", "--n", "1234", "--seed", "1"));
  const window = await openWindow(page, "table");
  assert.equal((await shown()).length, 500);
  assert.equal(await window.getByText("1–500 of 1234").count(), 1);
  await window.getByRole("button", { name: "Next" }).click();
  await window.getByRole("button", { name: "Next" }).click();
  assert.equal((await shown()).length, 234);
  assert.ok(await window.getByRole("button", { name: "Next" }).isDisabled());
  const all = await polygon();
  assert.deepEqual((await shown()).at(-1).map(Number), all.at(-1));
  assert.equal(await field(1001, "x").inputValue(), String(all[1000][0]));
});

test("on a phone it is the whole screen, for fingers", async () => {
  const small = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  const window = await openWindow(small, "table");
  const { width, height } = await window.boundingBox();
  assert.deepEqual([width, height], [phone.width, phone.height]);
  const sizes = await window
    .locator("button:visible, input:visible")
    .evaluateAll((all) => all.map((b) => b.getBoundingClientRect()).map((b) => Math.min(b.width, b.height)));
  assert.ok(Math.min(...sizes) >= 44, String(Math.min(...sizes)));
  assert.ok(await window.evaluate((r) => r.scrollWidth <= innerWidth));
  await window.getByRole("button", { name: "Close" }).tap();
  await allClosed(small);
  await small.done();
});

test("on a phone on its side it lies over the panel, and the drawing stays where it is", async () => {
  const low = await browser.open({ viewport: { width: 740, height: 360 }, hasTouch: true, isMobile: true });
  await idle(low);
  const corner = () => toScreen(low, [0, 0]);
  const before = await corner();
  await openWindow(low, "table");
  await idle(low);
  assert.deepEqual(await corner(), before);
  const window = await low.locator("#table").boundingBox();
  const panel = await controlIfShown(low, "fold");
  assert.ok(window.x < panel.x && window.x + window.width >= panel.x + panel.width);
  await low.done();
});
