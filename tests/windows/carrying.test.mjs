import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  controlIfShown,
  evenlift,
  idle,
  link,
  load,
  press,
  sharedBrowser,
  set,
  state,
  summary,
  toScreen,
  undo,
} from "../page/browser.mjs";

const browser = sharedBrowser();

const plainly = (text) => text.replaceAll("\u00a0", " ");

test("a slope is typed, and the page says the same as the program", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1300 } });
  await load(page, asset("grand-piano"));
  for (const [field, typed] of [
    ["com height", "600"],
    ["slope", "8"], // of the shown unit
    ["acceleration", "0,1 g"],
    ["give", "10"],
    ["uneven", "1"],
    ["extra", "60"],
  ]) {
    await press(page, field);
    await page.keyboard.press("Control+a");
    await page.keyboard.type(typed);
    await page.keyboard.press("Enter");
    await idle(page);
  }
  const now = await state(page);
  const printed = JSON.parse(evenlift("place", `#${await link(page)}`, "--json", "--candidates"));
  assert.equal(now.slope, 0.08);
  assert.deepEqual(now.tilt, printed.tilt);
  assert.deepEqual(now.extra, printed.extra);
  assert.deepEqual(now.loads, printed.loads);
  assert.match(plainly(await summary(page)), /In the worst direction it tips at a slope of 27\.8° \(52\.8 %\)/);
  assert.match(plainly(await summary(page)), /Another 60 kg may stand on \d+ % of the object/);
  await undo(page);
  await idle(page);
  assert.equal((await state(page)).extra, undefined);
  await page.done();
});

test("the overlays of slopes and of another load explain what is under the pointer", async () => {
  const page = await browser.open({ drawn: true });
  await load(page, asset("grand-piano"));
  assert.equal(await controlIfShown(page, "Tilt"), null, "nothing to show without a height");
  await set(page, { com_height: 600, extra: 12, capacity: 25 });
  await idle(page);
  const before = await page.screenshot();
  const differs = async (from) => assert.ok(!(await page.screenshot()).equals(from));
  await page.keyboard.press("Shift+S");
  await idle(page);
  await differs(before);
  const tilted = await page.screenshot();
  await page.keyboard.press("Shift+L");
  await page.mouse.move(...(await toScreen(page, [200, 300])));
  await idle(page);
  await differs(tilted);
  assert.match(await link(page), /^2\./);
  const overlays = (await state(page)).overlays;
  assert.equal(overlays.tilt && overlays.load, true);
  await page.done();
});

test("a link beyond the slope at which it tips opens with that news first", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { com_height: 600, slope: "60%" });
  await idle(page);
  assert.match(plainly(await summary(page)), /^On a slope of 60 % it tips\./);
  const { verdict } = await state(page);
  assert.equal(verdict.kind, "bad");
  await page.done();
});
