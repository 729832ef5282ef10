// Readings in the table of robots, and the table of load cases.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  drag,
  fragment,
  idle,
  load,
  phone,
  published,
  set,
  sharedBrowser,
  state,
  toScreen,
  undo,
} from "../page/browser.mjs";
import { openWindow } from "../page/windows.mjs";

const browser = sharedBrowser();

const plate = "(0,0)\n(1200,0)\n(1200,600)\n(500,600)\n(500,900)\n(0,900)\n";
const supports = "50,50 1150,50 1150,550 50,850";
const readings = ["169", "171", "100", "40"];

async function weighing(options = {}) {
  const page = await browser.open(options);
  await load(page, plate);
  await set(page, { supports });
  await idle(page);
  await page.keyboard.press("e");
  await page.locator("#table").waitFor();
  await page.locator("#table").getByRole("button", { name: "Robots", exact: true }).click();
  await idle(page);
  return page;
}

const fields = (page) => page.locator("#table tbody tr td.Reads input");

async function read(page, values) {
  for (const [i, value] of values.entries()) {
    await fields(page).nth(i).fill(value);
    await fields(page).nth(i).press("Enter");
  }
  await idle(page);
}

const plain = (text) => text.replaceAll("\u00a0", " ");
const said = async (page) => plain(await page.locator("#table .weighed").innerText());

for (const [name, options] of [
  ["on a wide screen", {}],
  ["on a phone", { viewport: phone, hasTouch: true }],
]) {
  test(`what all robots read gives the weight and C, ${name}`, async () => {
    const page = await weighing(options);
    assert.equal(await page.locator("#table .weighed").isVisible(), false);
    await read(page, readings.slice(0, 3));
    assert.match(await said(page), /: 1 still missing\./);
    assert.equal((await state(page)).weighing, undefined); // nothing changes until all are known
    await read(page, readings);
    assert.match(await said(page), /Weighed: 480 kg, C at \(671\.0, 220\.8\)/);
    const { weighing: found, total_weight, centre_of_mass } = await state(page);
    assert.equal(found.weight, 480);
    assert.equal(total_weight, 480);
    assert.deepEqual(centre_of_mass, found.centre_of_mass);

    await page.locator("#table").getByRole("button", { name: "Take over" }).click();
    await idle(page);
    const own = await state(page);
    assert.equal(own.weight, 480);
    assert.deepEqual(own.centre_of_mass, centre_of_mass);
    assert.equal(own.readings, undefined);
    assert.match(await said(page), /The weight and C are the object's now/);
    await undo(page);
    assert.deepEqual((await state(page)).readings, readings.map(Number));
    await page.done();
  });
}

test("one reading is cleared: the others stay in the table, and the weight is as before", async () => {
  const page = await weighing();
  await read(page, readings);
  await fields(page).nth(1).fill("");
  await fields(page).nth(1).press("Enter");
  await idle(page);
  assert.equal((await state(page)).total_weight, 100);
  assert.deepEqual(await fields(page).evaluateAll((all) => all.map(({ value }) => value)), ["169", "", "100", "40"]);
  await read(page, readings);
  assert.equal((await state(page)).total_weight, 480);
  await page.done();
});

test("Tab leads from reading to reading, and readings go with a robot that is deleted", async () => {
  const page = await weighing();
  await fields(page).first().focus();
  for (const value of readings.slice(0, 3)) {
    await page.keyboard.type(value);
    await page.keyboard.press("Tab");
  }
  await idle(page);
  const shown = () => fields(page).evaluateAll((all) => all.map(({ value }) => value));
  assert.deepEqual(await shown(), ["169", "171", "100", ""]);
  assert.equal((await state(page)).robots.length, 4);
  await page.getByRole("button", { name: "Delete robot 2", exact: true }).click();
  await idle(page);
  assert.deepEqual(await shown(), ["169", "100", ""], "each with its own robot");
  // From the last one to what follows from them.
  await read(page, ["169", "100"]);
  await fields(page).nth(2).focus();
  await page.keyboard.type("40");
  await page.keyboard.press("Tab");
  await idle(page);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Take over");
  await fields(page).nth(2).fill("");
  await fields(page).nth(2).press("Enter");
  await idle(page);
  // Without the robot that had none, all are known.
  await page.getByRole("button", { name: "Add a robot", exact: true }).click();
  await idle(page);
  await read(page, ["169", "171", "40"]);
  await page.getByRole("button", { name: "Delete robot 4", exact: true }).click();
  await idle(page);
  assert.equal((await state(page)).total_weight, 380);
  await page.done();
});

test("readings that wait stay when the table is opened again by its key", async () => {
  const page = await weighing();
  await read(page, readings.slice(0, 2));
  await page.keyboard.press("Escape");
  await page.locator("#canvas").focus();
  await page.keyboard.press("Shift+I");
  await page.locator("#table").waitFor();
  await idle(page);
  assert.deepEqual(await fields(page).evaluateAll((all) => all.map(({ value }) => value)), ["169", "171", "", ""]);
  await read(page, readings);
  assert.equal((await state(page)).total_weight, 480);
  await page.done();
});

test("a warning says that readings do not fit, and a word is no reading", async () => {
  const page = await weighing();
  await read(page, ["abc"]);
  assert.match(await page.locator("#table .problem").innerText(), /“abc” is not a weight of 0 or more/);
  await read(page, ["169", "400", "100", "400"]);
  assert.match(plain(await page.locator("#table .doubt").innerText()), /W and C are right if each reading is/);
  await page.done();
});

test("a robot that is dragged off the object keeps its reading", async () => {
  const page = await weighing();
  await read(page, readings);
  await page.keyboard.press("Escape");
  await drag(page, await toScreen(page, [1150, 50]), await toScreen(page, [1500, 300]));
  await idle(page);
  const { robots, readings: kept } = await state(page);
  assert.equal(robots.length, 4);
  assert.deepEqual(kept, readings.map(Number));
  await page.done();
});

test("readings that tell nothing are refused with the reason, and nothing changes", async () => {
  const page = await weighing();
  await read(page, ["1", "0", "0", "0"]);
  assert.match(await page.locator("#table .problem").innerText(), /C is at the edge of the supports' hull/);
  assert.equal((await state(page)).total_weight, 100);
  await read(page, ["12 m"]);
  assert.match(await page.locator("#table .problem").innerText(), /a length/);
  await page.done();
});

test("readings may be in another unit of weight, and go along in the link", async () => {
  const page = await weighing();
  await read(page, ["1000 N", "1000 N", "1000 N", "1000 N"]);
  const { total_weight } = await state(page);
  assert.ok(Math.abs(total_weight - 4000 / 9.80665) < 1e-4, String(total_weight));
  await published(page);
  const other = await browser.open({ address: `#${await fragment(page)}` });
  assert.equal((await state(other)).total_weight, total_weight);
  await other.done();
  await page.done();
});

test("what was weighed stays when readings no longer apply", async () => {
  const page = await weighing();
  await read(page, readings);
  const { centre_of_mass } = await state(page);
  await set(page, { metric: "balanced", robots: 6 });
  await idle(page);
  let now = await state(page);
  assert.equal(now.total_weight, 480);
  assert.deepEqual(now.centre_of_mass, centre_of_mass);
  await undo(page);
  // One robot more: it has no reading.
  await page.getByRole("button", { name: "Add a robot", exact: true }).click();
  await idle(page);
  now = await state(page);
  assert.equal(now.robots.length, 5);
  assert.equal(now.total_weight, 480);
  assert.equal(now.readings, undefined);
  await undo(page);
  await set(page, { weight: 500 });
  now = await state(page);
  assert.equal(now.total_weight, 500);
  assert.deepEqual(now.centre_of_mass, centre_of_mass);
  await page.done();
});

test("all cases of loading are a table with the worst one marked, to be printed", async () => {
  const page = await weighing();
  await read(page, readings);
  await set(page, { slope: "5%", com_height: 200, capacity: 200, dynamic: 1.1 });
  await page.keyboard.press("Escape");
  await idle(page);
  await page.locator("#mirror").getByRole("button", { name: "Carrying" }).dispatchEvent("click");
  await idle(page);
  await page.locator("#mirror").getByRole("button", { name: "All cases …" }).dispatchEvent("click");
  const rows = page.locator("#cases tbody tr");
  await rows.first().waitFor();
  assert.deepEqual(
    await rows.evaluateAll((all) => all.map((row) => row.firstElementChild.textContent.replaceAll("\u00a0", " "))),
    [
      "as given, level and still",
      "on slopes up to 5 %",
      ...[1, 2, 3, 4].map((robot) => `all of these, and robot ${robot} fails`),
    ],
  );
  assert.equal(await page.locator("#cases tr.worst").count(), 1);
  assert.match(
    plain(await page.locator("#cases").innerText()),
    /with a dynamic factor of 1\.1 and the weight as given/,
  );
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("#cases .paper-title").isVisible(), true);
  assert.equal(await page.locator("#canvas").isVisible(), false);
  await page.done();
});

async function handout(page) {
  await openWindow(page, "lessons");
  await page.locator("#lessons").getByRole("button", { name: "Handout" }).click();
  await page.locator("#handout figure").first().waitFor();
}

test("the handout of robots with conditions has all cases", async () => {
  const page = await weighing();
  await read(page, readings);
  await page.keyboard.press("Escape");
  await handout(page);
  assert.equal(await page.locator("#handout .cases").count(), 0, "no capacity, and no condition");
  await page.keyboard.press("Escape");
  await set(page, { slope: "5%", com_height: 200, capacity: 200 });
  await handout(page);
  assert.equal(await page.locator("#handout .cases tbody tr").count(), 6);
  assert.equal(await page.locator("#handout .cases tr.worst").count(), 1);
  await page.done();
});

test("with more robots than scales, one press takes away the others", async () => {
  const page = await browser.open();
  await page.keyboard.press("Shift+I");
  await page.locator("#table").waitFor();
  for (const [key, value] of ["12", "18", "31", "25"].entries()) {
    assert.equal(
      await page.evaluate(() => document.activeElement.getAttribute("aria-label")),
      `Robot ${key + 1}, reads`,
    );
    await page.keyboard.type(value);
    await page.keyboard.press("Enter");
  }
  assert.match(await said(page), /: 2 still missing\./);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Without the other 2 robots");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.match(await said(page), /Weighed: 86\.0 kg/);
  assert.equal((await state(page)).robots.length, 4);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Take over");
  assert.equal(await page.locator("#table thead th").nth(5).textContent(), "Expected");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Escape");
  await page.locator("#table").waitFor({ state: "detached" });
  await page.keyboard.press("z"); // the same load for each
  await idle(page);
  const { metric, loads, total_weight: weight } = await state(page);
  assert.deepEqual([metric, weight, loads.spread < 1e-9], ["balanced", 86, true]);
});

test("the keys' list finds weighing and equal loads, and Escape closes it at once", async () => {
  const page = await browser.open();
  for (const [words, key] of [
    ["scale weigh", "Shift+I"],
    ["equal load", "Z"],
  ]) {
    await page.keyboard.press("?");
    await page.locator("#keys").waitFor();
    await page.keyboard.type(words);
    assert.equal(await page.locator("#keys dl > div:not([hidden]) dd").first().innerText(), key);
    await page.keyboard.press("Escape");
    await page.locator("#keys").waitFor({ state: "detached" });
  }
});
