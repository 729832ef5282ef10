// The card follows every change, and the program marks what is handed in.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import {
  controlIfShown,
  drag,
  evenlift,
  idle,
  link,
  phone,
  reload,
  set,
  sharedBrowser,
  state,
  toScreen,
  undo,
} from "../page/browser.mjs";
import { closeAll, openWindow, paste, violations } from "../page/windows.mjs";

const browser = sharedBrowser();
const clipboard = ["clipboard-read", "clipboard-write"];
const plainly = (text) => text.replaceAll("\u00a0", " ");

const card = (page) => page.locator("#task");
async function goals(page) {
  return (await card(page).locator(".goals li").allInnerTexts()).map((text) => plainly(text).replaceAll("\n", " "));
}
const ticks = (page) => card(page).locator(".tick.kept").count();

const says = (page, words) => card(page).locator('.said [role="status"]', { hasText: words }).waitFor();

async function copied(page) {
  await page.locator("#task .ways").getByRole("button", { name: "Copy result" }).click();
  await idle(page);
  return page.evaluate(() => navigator.clipboard.readText());
}

test("a task is done by hand, and the copied result is marked as done by the program", async () => {
  const page = await browser.open({ address: "?lesson=place-yourself", permissions: clipboard });
  await card(page).waitFor();
  assert.equal(await card(page).locator("h2").innerText(), "Place robots yourself");
  await says(page, "Only the robots may be changed.");
  assert.equal(await ticks(page), 1, "it stands, but a robot carries too much");
  const to = [
    [200, 200],
    [800, 150],
    [850, 600],
    [200, 600],
  ];
  for (const [robot, at] of to.entries()) {
    const { robots } = await state(page);
    await drag(page, await toScreen(page, robots[robot].at), await toScreen(page, at));
    await idle(page);
  }
  await says(page, "Done!");
  assert.equal(await ticks(page), 2);
  assert.match((await goals(page))[1], /^The greatest load is at most 30 kg \d+\.\d+ kg$/);
  const address = await copied(page);
  assert.match(address, /\?lesson=place-yourself#/);
  assert.match(evenlift("check", address, "--task", "place-yourself"), /The task is done\./);
  assert.deepEqual(await violations(page), []);
  // The result's address opens it, with the task and its ticks.
  const other = await browser.open({ address: address.slice(address.indexOf("?")) });
  await says(other, "Done!");
  assert.deepEqual(await state(other), await state(page));
  await other.done();
  await page.done();
});

test("each number has a task of its own, which stays in the address and after a reload", async () => {
  const page = await browser.open({ address: "?lesson=task-thirty&number=4711", permissions: clipboard });
  await card(page).waitFor();
  const first = await state(page);
  const [, made] = [0, evenlift("generate", "star", "--n", "9", "--seed", "4711")];
  assert.equal(first.polygon.length, 9);
  assert.ok(made.includes(`(${first.polygon[0].join(",")})`));
  await idle(page);
  await page.waitForFunction(() => location.hash.length > 1);
  assert.match(page.url(), /\?lesson=task-thirty&number=4711#/);
  await reload(page);
  await card(page).waitFor();
  assert.deepEqual((await state(page)).polygon, first.polygon);
  // Another learner's number.
  const field = card(page).getByLabel("Your number");
  assert.equal(await field.inputValue(), "4711");
  await field.fill("12");
  await field.press("Enter");
  await page.waitForFunction(() => location.search.includes("number=12"));
  assert.notDeepEqual((await state(page)).polygon, first.polygon);
  await page.done();
});

// All robots of *Place robots yourself* where they do what it asks.
async function solve(page) {
  await set(page, { supports: "350,230 670,230 670,530 350,530" });
  await says(page, "Done!");
}

test("another number is asked about once something was done, and a task starts over", async () => {
  const page = await browser.open({ address: "?lesson=task-thirty&number=5" });
  await card(page).waitFor();
  const first = await state(page);
  const field = card(page).getByLabel("Your number"),
    restart = card(page).getByRole("button", { name: "Start over" });
  assert.equal(await restart.isVisible(), false, "nothing to take back");
  const [x, y] = first.supports[0];
  await set(page, { supports: [[x + 1, y], ...first.supports.slice(1)] });
  await idle(page);
  await field.fill("6");
  await field.press("Enter");
  await card(page).getByText("Number 6 has another object. What you did here is left behind.").waitFor();
  await card(page).getByRole("button", { name: "Stay with number 5" }).click();
  assert.equal(await field.inputValue(), "5");
  assert.deepEqual((await state(page)).supports[0], [x + 1, y]);
  await restart.click();
  await page.waitForFunction(([a, b]) => evenlift.state().supports[0].join() === `${a},${b}`, [x, y]);
  assert.deepEqual(await state(page), first);
  await set(page, { supports: [[x + 1, y], ...first.supports.slice(1)] });
  await idle(page);
  await field.fill("6");
  await field.press("Enter");
  await card(page).getByRole("button", { name: "Begin number 6" }).click();
  await page.waitForFunction(() => location.search.includes("number=6"));
  assert.notDeepEqual((await state(page)).polygon, first.polygon);
  await page.done();
});

test("a task shows what it asks about: no turns and no failures, unless it asks for them", async () => {
  const page = await browser.open();
  for (const [task, hold, failures] of [
    ["place-yourself", false, false],
    ["task-closed", true, false],
    ["task-steady", false, true],
  ]) {
    await openWindow(page, "lessons");
    await page.locator(`[data-name="${task}"]`).click();
    await card(page).waitFor();
    await idle(page);
    const { overlays } = await state(page);
    assert.equal(overlays?.clockwise ?? true, hold, task);
    assert.equal(Boolean(await controlIfShown(page, "failures")), failures, task);
  }
  await page.done();
});

test("on a phone the object of a task has half of the screen", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true });
  for (const task of ["place-yourself", "task-where-is-c", "task-closed", "task-thirty", "task-steady"]) {
    await openWindow(page, "lessons");
    await page.locator(`[data-name="${task}"]`).click();
    await card(page).waitFor();
    await idle(page);
    const { y } = await card(page).boundingBox();
    const below = 56; // of the toolbar
    assert.ok(y - below >= phone.height / 2, `${task}: ${y - below} of ${phone.height}`);
  }
  await page.done();
});

test("what a finger drags is shown larger in a corner, and what a mouse drags is not", async () => {
  const page = await browser.open({
    drawn: true,
    address: "?lesson=task-where-is-c",
    viewport: phone,
    hasTouch: true,
    isMobile: true,
  });
  await card(page).waitFor();
  await idle(page);
  const corner = { clip: { x: phone.width - 130, y: 75, width: 110, height: 110 } }; // within the loupe's edge
  const session = await page.context().newCDPSession(page);
  const finger = (type, ...touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  const at = async () => {
    const [x, y] = await toScreen(page, (await state(page)).centre_of_mass);
    return { x, y };
  };
  const { x, y } = await at();
  await finger("touchStart", { x, y });
  for (let i = 1; i <= 8; ++i) await finger("touchMove", { x: x - 2 * i, y });
  await idle(page);
  const during = await page.screenshot(corner);
  await finger("touchEnd");
  await idle(page);
  const after = await page.screenshot(corner);
  assert.ok((await browser.compare(during, after)).share > 0.5, "the loupe is full of the lifting base");
  const from = await at();
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 8, from.y, { steps: 4 });
  await idle(page);
  assert.ok((await browser.compare(await page.screenshot(corner), after)).share < 0.02);
  await page.mouse.up();
  await page.done();
});

test("Done! is the largest text on the card, and the verdict agrees", async () => {
  const page = await browser.open({ address: "?lesson=place-yourself" });
  await card(page).waitFor();
  await solve(page);
  const size = (locator) => locator.evaluate((element) => Number.parseFloat(getComputedStyle(element).fontSize));
  const done = await size(card(page).locator(".state b"));
  assert.ok(done > 1.4 * (await size(card(page).locator("h2"))), String(done));
  await page.done();
});

test("what a task does not allow is said, and undo brings it back", async () => {
  const page = await browser.open({ address: "?lesson=task-motor" });
  await card(page).waitFor();
  await set(page, { weight: 90 });
  await idle(page);
  await card(page).locator(".goals").getByText("You changed the weight, which this task does not allow.").waitFor();
  await undo(page);
  await card(page).locator(".goals").getByText("You changed").waitFor({ state: "detached" });
  await set(page, { cargo: "381.4,389.6:40:motor" });
  await says(page, "Done!");
  // The answer takes a second press.
  await card(page).getByRole("button", { name: "Question" }).click();
  await card(page).getByText("Must the motor lie above").waitFor();
  await card(page).getByRole("button", { name: "Answer" }).click();
  await card(page).getByText("No. C is the centre of mass of slab and motor together").waitFor();
  await page.done();
});

test("C is hidden, and is found by the loads that the scales show", async () => {
  const page = await browser.open({ address: "?lesson=task-where-is-c&number=3" });
  await card(page).waitFor();
  const rows = await goals(page);
  assert.equal(rows.length, 3);
  const readings = rows.map((row) => Number(/should carry ([\d.]+) kg/.exec(row)[1]));
  const { supports } = await state(page);
  const sum = readings.reduce((a, b) => a + b);
  const centre = [0, 1].map((axis) => readings.reduce((total, load, i) => total + load * supports[i][axis], 0) / sum);
  await set(page, { com: centre });
  await says(page, "Done!");
  await page.done();
});

test("a task of robots by hand does not offer the methods that would solve it", async () => {
  const page = await browser.open();
  for (const [task, methods] of [
    ["task-thirty", 0],
    ["task-beat-balanced", 1],
  ]) {
    await openWindow(page, "lessons");
    await page.locator(`[data-name="${task}"]`).click();
    await card(page).waitFor();
    await idle(page);
    for (const name of ["methods", "compared"])
      assert.equal(Boolean(await controlIfShown(page, name)), methods === 1, `${task} ${name}`);
    const before = (await state(page)).metric;
    await page.locator("#canvas").focus();
    await page.keyboard.press("m");
    await idle(page);
    assert.equal((await state(page)).metric !== before, methods === 1, task);
    await page.keyboard.press("Control+z");
    await idle(page);
  }
  await page.done();
});

test("Copy link copies the task as it begins, and Copy result what was done", async () => {
  const page = await browser.open({ permissions: clipboard });
  await openWindow(page, "lessons");
  await page.locator('[data-name="task-beat-balanced"]').click();
  await card(page).waitFor();
  await set(page, { min_ratio: 0.6 });
  await says(page, "Done!");
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await page.locator("#canvas").focus();
  await page.keyboard.press("Control+c");
  await idle(page);
  const bare = await copied();
  assert.match(bare, /\?lesson=task-beat-balanced$/);
  const root = await openWindow(page, "save");
  assert.equal(await root.locator("input").first().inputValue(), bare);
  await closeAll(page);
  await card(page).getByRole("button", { name: "Copy result" }).click();
  await idle(page);
  assert.match(await copied(), /\?lesson=task-beat-balanced#1\./);
  await page.done();
});

test("a task's card folds, by Escape too, and nothing of the task is lost", async () => {
  const page = await browser.open({ viewport: phone });
  await openWindow(page, "lessons");
  await page.locator('[data-name="task-beat-balanced"]').click();
  await card(page).waitFor();
  const high = () => card(page).evaluate((e) => e.offsetHeight);
  const unfolded = await high();
  await card(page).getByRole("button", { name: "Fold", exact: true }).click();
  await idle(page);
  assert.ok((await high()) < 70 && unfolded > 150, `${unfolded}, ${await high()}`);
  assert.match(await card(page).innerText(), /: \d of \d/);
  assert.match(page.url(), /lesson=/);
  await set(page, { min_ratio: 0.6 });
  await idle(page);
  assert.match(await card(page).innerText(), /^Done!/);
  await card(page).getByRole("button", { name: "Unfold" }).click();
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await card(page).count(), 1, "Escape folds");
  assert.ok((await high()) < 70);
  await page.done();
});

test("closing a task brings back the work from before it, and it is marked as seen once it was done", async () => {
  const page = await browser.open();
  await set(page, { teams: 4 });
  await idle(page);
  const before = await link(page);
  await openWindow(page, "lessons");
  await page.locator('[data-name="task-beat-balanced"]').click();
  await card(page).waitFor();
  await set(page, { min_ratio: 0.6 });
  await says(page, "Done!");
  await card(page).getByRole("button", { name: "Leave the task" }).click();
  await idle(page);
  assert.equal(await link(page), before);
  assert.doesNotMatch(page.url(), /lesson=/);
  await openWindow(page, "lessons");
  assert.match(await page.locator('[data-name="task-beat-balanced"]').innerText(), /seen/);
  assert.match(await page.locator("#lessons").innerText(), /Session 2: The algorithm, about \d+ minutes/);
  await closeAll(page);
  await page.done();
});

test("a task of one's own is pasted, and undoing past its beginning closes it", async () => {
  const page = await browser.open();
  const before = await link(page);
  await paste(page, "title: Mine\npolygon: square\nrequire: held\nmove: teams\n\n[task]\nMake it held.\n");
  await card(page).waitFor();
  assert.deepEqual(await goals(page), ["The robots hold the object no"]);
  await undo(page);
  await card(page).waitFor({ state: "detached" });
  assert.equal(await link(page), before);
  await page.done();
});

test("a task after the steps of a lesson waits at its last step", async () => {
  const page = await browser.open();
  await paste(
    page,
    "title: Mine\npolygon: square\nteams: 1\nrequire: robots>=4\nmove: teams\n\n[centre]\nC.\n\n[end]\nE.\n\n[task]\nMore.\n",
  );
  await page.waitForFunction(() => document.getElementById("summary").textContent.includes("Step 1 of 2"));
  await page.keyboard.press("End");
  await card(page).waitFor();
  await set(page, { teams: 2 });
  await says(page, "Done!");
  await page.keyboard.press("Home");
  await card(page).waitFor({ state: "detached" });
  await page.done();
});

test("on a phone the card leaves the object in sight", async () => {
  const page = await browser.open({ address: "?lesson=place-yourself", viewport: phone, hasTouch: true });
  await card(page).waitFor();
  await idle(page);
  const box = await card(page).boundingBox();
  for (const robot of (await state(page)).robots) {
    const at = await toScreen(page, robot.at);
    assert.ok(at[1] < box.y, `a robot at ${at[1]} is below the card's edge at ${box.y}`);
  }
  await page.done();
});

test("a file of what a class hands in is marked with one command", async () => {
  const page = await browser.open({ address: "?lesson=task-thirty&number=1", permissions: clipboard });
  await card(page).waitFor();
  const one = await copied(page);
  const folder = mkdtempSync(path.join(tmpdir(), "evenlift-"));
  try {
    const file = path.join(folder, "handed-in.txt");
    writeFileSync(file, `Ada ${one}\nBen;${one.replace("#", "?x#")}\n`);
    assert.throws(
      () => evenlift("check", file, "--task", "task-thirty"),
      (error) => {
        assert.equal(error.status, 3);
        assert.match(String(error.stdout), / 1 +Ada +1 +no /);
        return true;
      },
    );
  } finally {
    rmSync(folder, { recursive: true });
  }
  await page.done();
});

// The card is on the screen, and the object beside it has a share of the screen's width or height.
async function isBeside(page, { width, height }, [leastWide, leastHigh]) {
  await idle(page);
  const { polygon } = await state(page);
  const corners = await Promise.all(polygon.map((vertex) => toScreen(page, vertex)));
  const [xs, ys] = [0, 1].map((axis) => corners.map((corner) => corner[axis]));
  const box = await card(page).boundingBox();
  assert.ok(Math.max(...xs) < box.x, "the object is left of the card");
  assert.ok(box.y >= 0 && box.y + box.height <= height, "the card is on the screen");
  const [wide, high] = [xs, ys].map((all) => Math.max(...all) - Math.min(...all));
  assert.ok(wide > leastWide * width || high > leastHigh * height, `the object is ${wide} by ${high}`);
}

test("before a room the card of a task is beside the object, which stays large", async () => {
  const viewport = { width: 1920, height: 1080 };
  const page = await browser.open({ address: "?lesson=task-thirty", viewport });
  await page.evaluate(() => {
    document.documentElement.requestFullscreen = async () => {};
  });
  await card(page).waitFor();
  await page.locator("#canvas").focus();
  await page.keyboard.press("Shift+P");
  await isBeside(page, viewport, [0.35, 0.5]);
  await page.done();
});

test("in a frame that is wider than high the card of a task is beside the object, too", async () => {
  const viewport = { width: 640, height: 420 };
  const page = await browser.open({ address: "?lesson=task-thirty&embed=1", viewport });
  await card(page).waitFor();
  await isBeside(page, viewport, [0.3, 0.4]);
  await page.done();
});
