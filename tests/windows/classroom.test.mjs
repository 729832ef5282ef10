// A teacher's lesson as a link, presenting, tips for fingers, formulas on request.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { control, evenlift, fragment, idle, phone, press, reload, sharedBrowser, state } from "../page/browser.mjs";
import { closeAll, noticed, openWindow, paste } from "../page/windows.mjs";

const browser = sharedBrowser();

const ownLesson = `title: My own slab
polygon: stone-slab
teams: 2

[centre]
What do you notice about C? Here are my own words.

[end]
Remember this.

[question]
Why two teams?

[answer]
Because four robots are here.
`;
const ownLink = (link) => `title: By a script\nlink: ${link}\n\n[centre]\nHere is C.\n`;
const ownTask = `title: Wide enough
polygon: worktop
metric: area
teams: 2
require: coverage>=0.1
move: teams, centre

[task]
Cover at least a tenth.
`;
// The program's link to this lesson.
function linkTo(text) {
  const folder = mkdtempSync(path.join(tmpdir(), "evenlift-"));
  const file = path.join(folder, "lesson.txt");
  try {
    writeFileSync(file, text);
    return evenlift("link", "lesson", file).trim();
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const lessonIsOpen = (page) =>
  page.waitForFunction(() => document.querySelector("#summary").textContent.includes("Step 1 of"));

test("a link opens the lesson that it holds, and every address of the lesson holds it too", async () => {
  const lesson = linkTo(ownLesson);
  assert.match(lesson, /^L1\.[\w-]+$/);
  const page = await browser.open({ address: `#${lesson}` });
  await lessonIsOpen(page);
  await idle(page);
  assert.match(await page.locator("#summary").textContent(), /Here are my own words/);
  assert.equal((await state(page)).robots.length, 4);
  assert.match(await fragment(page), new RegExp(`^[12]\\.[\\w-]+&${lesson}$`));
  assert.equal(await page.evaluate(() => location.search), "", "the text is not sent to the server");
  await page.locator("#canvas").focus();
  await page.keyboard.press("ArrowRight");
  await idle(page);
  assert.match(await page.locator("#summary").textContent(), /Remember this/);
  await reload(page);
  assert.match(await page.locator("#summary").textContent(), /Remember this/, "the reload is at the same step");
  await page.done();
});

test("the editor copies a link to its lesson, and refuses while the text has a mistake", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  const lessons = await openWindow(page, "lessons");
  await lessons.getByRole("button", { name: "Write a lesson" }).click();
  const editor = page.locator("#editor");
  const field = editor.locator("textarea");
  const copy = editor.getByRole("button", { name: "Copy link to this lesson" });
  await field.fill("title: My own slab\npolygon: stone-slab\n[nowhere]\nWords.\n");
  await idle(page);
  await copy.click();
  await idle(page);
  assert.match(await editor.locator(".problem").textContent(), /^Correct the lesson before you link to it: line 3/);
  await field.fill(ownLesson);
  await idle(page);
  await copy.click();
  await editor.getByText(/The link is copied\. It holds the whole lesson, in \d+ characters\./).waitFor();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(new URL(address).hash, `#${linkTo(ownLesson)}`);
  assert.equal(evenlift("link", "decode", address), ownLesson);
  await page.done();
});

test("a pasted link to a lesson opens it, a damaged one changes nothing, and a lesson from a file can be shared", async () => {
  const page = await browser.open();
  const before = await fragment(page);
  const lesson = linkTo(ownLesson);
  await paste(page, `https://example.org/#${lesson.slice(0, -1)}_`);
  assert.match(await noticed(page), /the link was cut off or altered/);
  assert.equal(await fragment(page), before);
  await paste(page, `https://example.org/#${lesson}`);
  await lessonIsOpen(page);
  await idle(page);
  assert.ok((await fragment(page)).endsWith(`&${lesson}`));
  await page.keyboard.press("Control+z");
  await idle(page);
  await paste(page, ownLesson);
  await lessonIsOpen(page);
  await idle(page);
  assert.ok((await fragment(page)).endsWith(`&${lesson}`), "its text is its address");
  await page.done();
});

test("a lesson's address opens it in a running page, embedded, and after all steps were shown", async () => {
  const lesson = linkTo(ownLesson);
  const page = await browser.open();
  await page.evaluate((hash) => {
    location.hash = hash;
  }, lesson);
  await lessonIsOpen(page);
  await idle(page);
  const address = await fragment(page);
  assert.ok(address.endsWith(`&${lesson}`));
  await page.locator("#canvas").focus();
  for (const times of [1, 2]) {
    await page.keyboard.press("u");
    await idle(page);
    if (times === 2) assert.equal(await fragment(page), address, "the lesson is back, and so is its address");
  }
  await page.done();
  const figure = await browser.open({ address: `?embed=1#${lesson}` });
  await idle(figure);
  assert.match(await figure.locator("#summary").textContent(), /Here are my own words/);
  await figure.done();
});

test("a drawing or a note that has the same letters is no lesson", async () => {
  const page = await browser.open();
  const drawing = '<path d="M0 0H40V40Z" fill="url(#L1.5)"/>';
  await paste(
    page,
    `<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40">${drawing}</svg>`,
  );
  await idle(page);
  assert.equal((await state(page)).polygon.length, 3);
  await page.evaluate((link) => evenlift.load(link), linkTo(ownLink(await fragment(page))));
  await idle(page);
  assert.match(await fragment(page), /&L1\./, "a script opens a link to a lesson, too");
  await page.done();
});

test("a task of one's own is handed in by its address, and marked with its link", async () => {
  const lesson = linkTo(ownTask);
  const page = await browser.open({ address: `?number=5#${lesson}` });
  await page.locator("#task").waitFor();
  await idle(page);
  const address = await page.evaluate(() => location.href);
  assert.match(address, /\?number=5#[12]\.[\w-]+&L1\./);
  const marked = JSON.parse(evenlift("check", address, "--task", lesson, "--json"));
  assert.equal(marked.results[0].number, 5);
  const other = await browser.open();
  await paste(other, `<${address}>`);
  await other.locator("#task").waitFor();
  await idle(other);
  assert.equal(
    await other.evaluate(() => location.href.split("?")[1]),
    address.split("?")[1],
    "pasted, it is the same",
  );
  await other.done();
  await page.done();
});

test("a damaged link to a lesson in the address is told in one sentence", async () => {
  const page = await browser.open({ address: "#L1.abcdefghijkl" });
  assert.equal(
    await noticed(page),
    "The lesson of this address cannot be opened: the link was cut off or altered on its way.",
  );
  await page.done();
});

test("presentation mode enlarges the tool and its windows, and Escape ends it", async () => {
  const page = await browser.open({ viewport: { width: 1920, height: 1080 } });
  await page.evaluate(() => {
    document.documentElement.requestFullscreen = async () => {};
  });
  const small = await control(page, "Samples");
  await page.locator("#canvas").focus();
  await page.keyboard.press("P");
  await idle(page);
  const large = await control(page, "Samples");
  assert.ok(large.height > 1.8 * small.height, `${small.height} became ${large.height}`);
  assert.ok(await control(page, "teams"), "settings stay in reach");
  const window = await openWindow(page, "lessons");
  const { width, height, x, y } = await window.boundingBox();
  assert.ok(width > 1300, `the window is ${width} wide`);
  assert.ok(x >= 0 && y >= 0 && x + width <= 1920 && y + height <= 1080, "it is on the screen");
  const letters = await window.locator("h2").evaluate((h2) => h2.getBoundingClientRect().height);
  await closeAll(page);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal((await control(page, "Samples")).height, small.height);
  const usual = await (
    await openWindow(page, "lessons")
  )
    .locator("h2")
    .evaluate((h2) => h2.getBoundingClientRect().height);
  assert.ok(letters > 1.8 * usual);
  await page.done();
});

test("a finger that rests on a control sees its tip and presses nothing; a tap presses it", async () => {
  const page = await browser.open({ viewport: phone, hasTouch: true, isMobile: true, hasty: true, drawn: true });
  const { middle } = await control(page, "Undo");
  const finger = await page.context().newCDPSession(page);
  const touch = (type, ...touchPoints) => finger.send("Input.dispatchTouchEvent", { type, touchPoints });
  const [x, y] = (await control(page, "Samples")).middle;
  assert.ok(middle[1] === y, "both are in the toolbar");
  const clip = { x: 0, y: y + 40, width: phone.width, height: 60 };
  const before = await page.screenshot({ clip });
  await touch("touchStart", { x, y });
  await page.evaluate(() => evenliftTimersRing());
  await idle(page);
  const asked = await page.screenshot({ clip });
  assert.ok(!asked.equals(before), "there is a tip below the finger");
  await touch("touchEnd");
  await idle(page);
  assert.equal(await page.locator("#samples").count(), 0, "nothing was pressed");
  assert.ok((await page.screenshot({ clip })).equals(before), "the tip is gone");
  await page.touchscreen.tap(x, y);
  await page.locator("#samples").waitFor();
  await page.done();
});

test("a step shows its formula and the algorithm on request, and keeps them for the next", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  await page.keyboard.press("b");
  await idle(page);
  await page.getByRole("button", { name: "Show formula and algorithm" }).waitFor();
  await press(page, "formula");
  await page.getByRole("button", { name: "Hide formula and algorithm" }).waitFor();
  await page.keyboard.press("ArrowRight");
  await idle(page);
  await page.getByRole("button", { name: "Hide formula and algorithm" }).waitFor();
  await page.done();
});
