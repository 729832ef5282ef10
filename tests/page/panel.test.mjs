// Typed values, controls reached by keys; nothing moves or leaves the window.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import {
  asset,
  control,
  controlIfShown,
  drawsNothing,
  idle,
  load,
  lShape,
  openDrawers,
  phone,
  press,
  root,
  set,
  sharedBrowser,
  state,
  tap,
  toScreen,
  type,
} from "./browser.mjs";
import { noticed, paste } from "./windows.mjs";

const browser = sharedBrowser();

const touch = { hasTouch: true, isMobile: true };
const sizes = [
  [320, 568, touch],
  [390, 844, touch],
  [844, 390, touch],
  [820, 1180, touch],
  [1180, 820, touch],
  [820, 1180, {}],
  [1024, 768, {}],
  [1440, 900, {}],
  [3840, 2160, {}],
];

const mirrored = (page) =>
  page.$$eval("#mirror > div > :not(p)", (elements) =>
    elements.map((element) => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      return {
        label: element.getAttribute("aria-label"),
        card: element.parentElement.getAttribute("aria-label"),
        left,
        top,
        right,
        bottom,
      };
    }),
  );
const heightOfC = async (page) => Number(await field(page, "Height of the centre of mass").inputValue());
const field = (page, label) => page.locator(`#mirror input[aria-label="${label}"]`);

test("a number is clicked and typed over, with its unit and a decimal comma or without", async () => {
  const page = await browser.open();
  await press(page, "weight");
  await page.keyboard.type("437");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).weight, 437);
  await press(page, "weight");
  await page.keyboard.type("12,5 kg");
  await page.keyboard.press("Tab");
  await idle(page);
  assert.equal((await state(page)).weight, 12.5);
  await press(page, "com");
  await page.keyboard.type("300, 250.5");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.deepEqual((await state(page)).centre_of_mass, [300, 250.5]);
  await press(page, "min ratio");
  await page.keyboard.type("0.455");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).min_ratio, 0.455);
  await page.done();
});

test("a number with another unit of the same kind is converted, not taken as it stands", async () => {
  const page = await browser.open();
  await openDrawers(page, "Robots");
  await idle(page);
  for (const [unit, typed, radius] of [
    ["mm", "2 cm", 20],
    ["mm", "1,5in", 38.1],
    ["m", "7 mm", 0.007],
    ["in", "2.54 cm", 1],
    ["cm", "3 cm", 3],
  ]) {
    await set(page, { unit });
    await type(page, "robot radius", typed);
    assert.equal((await state(page)).robot.radius, radius, `${typed} in ${unit}`);
  }
  for (const [weight_unit, typed, weight] of [
    ["kg", "2 t", 2000],
    ["kg", "50 lb", 22.6796185],
    ["kg", "9.80665 N", 1],
    ["N", "1 kg", 9.80665],
    ["lb", "0.45359237 kg", 1],
  ]) {
    await set(page, { weight_unit });
    await type(page, "weight", typed);
    assert.equal((await state(page)).weight, weight, `${typed} in ${weight_unit}`);
  }
  await set(page, { unit: "mm" });
  await type(page, "com", "60 cm, 20 cm");
  assert.deepEqual((await state(page)).centre_of_mass, [600, 200]);
  await type(page, "com", "610,205");
  assert.deepEqual(
    (await state(page)).centre_of_mass,
    [610, 205],
    "one number is no centre of mass, so its comma parts two",
  );
  await page.done();
});

test("a unit of another kind is refused, and so is one where numbers have none", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1200 } }); // all settings are visible at once
  await openDrawers(page, "Robots");
  await set(page, { unit: "none" });
  const before = await state(page);
  for (const [name, typed, why] of [
    [
      "robot radius",
      "5 mm",
      /^“5 mm” has the unit mm, but lengths have none here: type the number alone, or choose a unit of length under Object\.$/,
    ],
    ["weight", "5 mm", /^“5 mm” is a length, but this number is a weight in kg\.$/],
    ["teams", "4 kg", /^“4 kg” has the unit kg, but this number has none/],
    ["min ratio", "0.5 m", /^“0\.5 m” has the unit m,/],
    ["com", "300 mm, 250 mm", /^“300 mm, 250 mm” has the unit mm,/],
    ["weight", "heavy", /^The weight must be a number greater than 0/],
    [
      "weight",
      "500 g",
      /^“g” is not a unit that evenlift knows: lengths are in m, cm, mm or in, and weights in kg, t, N or lb\.$/,
    ],
    ["weight", "1,000", /^“1,000” may mean 1000 or 1: type one of these\.$/],
  ]) {
    await type(page, name, typed);
    assert.match(await page.locator("#alert").textContent(), why);
    await page.keyboard.press("Escape");
    await idle(page);
    assert.deepEqual(await state(page), before, typed);
  }
  await page.done();
});

test("a number with two readings is settled by a button, and typing after a refusal replaces the text", async () => {
  const page = await browser.open();
  await type(page, "weight", "1,250");
  const which = page.getByRole("group", { name: "Which number is meant?" });
  assert.deepEqual(await which.getByRole("button").allTextContents(), ["1250", "1.25"]);
  await which.getByRole("button").first().click();
  await idle(page);
  assert.equal((await state(page)).weight, 1250);
  assert.equal(await which.count(), 0);
  await type(page, "weight", "1,500 kg");
  await page.keyboard.press("Tab"); // to the buttons
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).weight, 1.5);
  await type(page, "weight", "1,000");
  await page.keyboard.type("7");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).weight, 7);
  await page.done();
});

test("by keys, a button that begins to draw leaves the focus on the drawing", async () => {
  const page = await browser.open();
  for (const name of ["Draw", "Hole"]) {
    const button = page.locator("#mirror").getByRole("button", { name, exact: true });
    await button.focus();
    await page.keyboard.press("Enter");
    await idle(page);
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
  }
  await page.done();
});

test("a number that is left as it is shown keeps all its digits", async () => {
  const page = await browser.open();
  await page.evaluate(() => evenlift.set({ min_ratio: 0.123456789 }));
  await press(page, "min ratio");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).min_ratio, 0.123456789);
  await page.done();
});

test("what cannot be a value is refused with a sentence, and changes nothing", async () => {
  const page = await browser.open();
  await press(page, "teams");
  await page.keyboard.type("many");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.match(await page.locator("#alert").textContent(), /^The number of teams must be a whole number .*\.$/);
  assert.equal(await field(page, "Teams").getAttribute("aria-invalid"), "true");
  assert.equal((await state(page)).requested_teams, 3);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal((await state(page)).requested_teams, 3);
  await page.done();
});

test("every setting is reached and changed by keys alone", async () => {
  const page = await browser.open();
  await page.evaluate((text) => evenlift.load(text), lShape);
  await openDrawers(page, "Object", "Robots", "Carrying", "Show", "Compare");
  await page.focus("#canvas");
  const reached = [];
  for (let i = 0; i < 110; ++i) {
    await page.keyboard.press("Tab");
    const label = await page.evaluate(
      () => document.activeElement.closest("#mirror") && document.activeElement.getAttribute("aria-label"),
    );
    if (!label || reached.includes(label)) continue;
    reached.push(label);
    if (label === "Method") {
      await page.keyboard.press("ArrowDown");
      await idle(page);
      assert.equal((await state(page)).metric, "circle");
    }
    if (label === "Teams") {
      await page.keyboard.press("ArrowUp");
      await idle(page);
      assert.equal((await state(page)).requested_teams, 4);
    }
    if (label === "Minimum load ratio, as a slider") {
      await page.keyboard.press("ArrowLeft");
      await idle(page);
      assert.equal((await state(page)).min_ratio, 0.79);
    }
    if (label === "Candidates") {
      await page.keyboard.press("Space");
      await idle(page);
      assert.equal(await page.locator('#mirror [aria-label="Candidates"]').getAttribute("aria-pressed"), "true");
    }
  }
  for (const label of [
    "Samples",
    "Draw",
    "Open",
    "Save",
    "More",
    "Method",
    "Teams",
    "A team on every candidate chord",
    "Minimum load ratio",
    "Minimum load ratio, as a slider",
    "Candidates",
    "Weight in kg",
    "Centre of mass, x and y",
    "Compare with",
    "Base",
    "Tipping",
  ])
    assert.ok(reached.includes(label), `${label} is not among ${reached.join(" · ")}`);
  await page.done();
});

test("each card has its place in the order of reading, and a name only while something is on it", async () => {
  const panels = path.join(root, "wasm/panels");
  const sources = readdirSync(panels)
    .map((name) => readFileSync(path.join(panels, name), "utf8"))
    .join("");
  const begun = [...sources.matchAll(/begin_card\(\s*ui, "([^"]+)"/g)].map(([, card]) => card);
  const [, listed] = /cards = new Map\(\[(.*?)\]\);/s.exec(
    readFileSync(path.join(root, "web/mirror/mirror.js"), "utf8"),
  );
  assert.deepEqual([...listed.matchAll(/\["([^"]+)"/g)].map(([, card]) => card).sort(), begun.sort());
  const page = await browser.open();
  const groups = () =>
    page.$$eval("#mirror > div", (all) =>
      all.filter((e) => e.checkVisibility()).map((e) => e.getAttribute("aria-label")),
    );
  await idle(page);
  assert.deepEqual(await groups(), ["Toolbar", "Panel", "View"]);
  await page.keyboard.press("w");
  await page.keyboard.press("Control+c"); // a notice reports it
  await idle(page);
  assert.deepEqual(await groups(), ["Toolbar", "Tool", "Panel", "View", "Notice"]);
  await page.done();
});

test("each value that can be typed has a key", async () => {
  const page = await browser.open();
  await idle(page);
  await page.evaluate(() => evenlift.set({ metric: "random" }));
  await page.focus("#canvas");
  for (const [key, typed, name, value] of [
    ["y", "437", "weight", 437],
    ["R", "0.5", "min_ratio", 0.5],
    ["U", "77", "seed", 77],
    ["j", "400 300", "centre_of_mass", [400, 300]],
  ]) {
    await page.keyboard.press(key);
    await idle(page);
    await page.keyboard.type(typed);
    await page.keyboard.press("Enter");
    await idle(page);
    assert.deepEqual((await state(page))[name], value);
  }
  await page.keyboard.press("Y");
  await idle(page);
  await page.keyboard.type("30");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).capacity.limit, 30);
  await page.keyboard.press("J");
  await page.evaluate(() => evenlift.set({ metric: "area" }));
  await page.keyboard.press("*");
  await idle(page);
  const all = await state(page);
  assert.equal(all.teams.length, all.candidates.length);
  await page.done();
});

test("the focus is seen, on the canvas and on each control", async () => {
  const page = await browser.open();
  await page.focus("#canvas");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Shift+Tab");
  const outline = () => page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
  assert.equal(await outline(), "solid");
  for (let i = 0; i < 12; ++i) {
    await page.keyboard.press("Tab");
    assert.equal(await outline(), "solid");
  }
  await page.done();
});

test("a control that is scrolled out of the panel is brought into it by the focus", async () => {
  const page = await browser.open({ viewport: { width: 1000, height: 420 } });
  const element = page.locator('#mirror [aria-label^="Team 1,"]');
  await element.focus();
  await idle(page);
  const { y, height } = await element.boundingBox();
  assert.ok(y >= 0 && y + height <= 420);
  assert.doesNotMatch((await element.getAttribute("class")) ?? "", /unseen/);
  await page.done();
});

for (const [width, height, options] of sizes) {
  const name = `${width} × ${height}${options.hasTouch ? ", by finger" : ""}`;
  test(`everything that can be pressed is in the window, and large enough: ${name}`, async () => {
    const page = await browser.open({ viewport: { width, height }, ...options });
    await idle(page);
    for (const list of [undefined, "more", "methods"]) {
      const begin = list && (await controlIfShown(page, list));
      if (begin) {
        if (begin.y + begin.height > height) continue; // in the sheet's part that is not pulled up
        await (options.hasTouch ? tap : press)(page, list);
        await idle(page);
      }
      const outside = (await mirrored(page))
        .filter(({ card }) => card !== "Panel" || list === "methods")
        .filter(({ left, right }) => left < 0 || right > width);
      assert.deepEqual(outside, [], `with ${list ?? "no list"}`);
      const toolbar = (await mirrored(page)).filter(({ card }) => card === "Toolbar");
      assert.ok(toolbar.length >= 6);
      if (options.hasTouch) for (const { right, left } of toolbar) assert.ok(right - left >= 40);
      await page.keyboard.press("Escape");
      await idle(page);
    }
    await page.done();
  });
}

test("a list that is open covers the fields below it", async () => {
  const page = await browser.open();
  for (const [name, metric] of [
    ["Random", "random"],
    ["Distance", "distance"],
    ["Equal angles", "distributed"],
    ["Circle", "circle"],
    ["Area", "area"],
  ]) {
    await press(page, "methods");
    await press(page, name);
    await idle(page);
    assert.equal((await state(page)).metric, metric);
  }
  await page.done();
});

test("a finger scrolls the toolbar's menu to its end, and takes the last row", async () => {
  for (const [width, height] of [
    [740, 360],
    [320, 568],
  ]) {
    const page = await browser.open({ viewport: { width, height }, ...touch });
    await tap(page, "more");
    const {
      middle: [x, y],
    } = await control(page, "Coordinates");
    const rows = async () => {
      await idle(page);
      return (await mirrored(page)).filter(({ label }) => ["Coordinates", "About evenlift"].includes(label));
    };
    const client = await page.context().newCDPSession(page);
    const finger = (type, ...at) =>
      client.send("Input.dispatchTouchEvent", { type, touchPoints: at.map(([px, py], id) => ({ x: px, y: py, id })) });
    for (let stroke = 0; stroke < 3; ++stroke) {
      await finger("touchStart", [x, y]);
      for (let i = 1; i <= 8; ++i) await finger("touchMove", [x, y - 20 * i]);
      await finger("touchEnd");
      await idle(page);
    }
    const about = (await rows()).find(({ label }) => label === "About evenlift");
    assert.ok(
      about.top > 0 && about.bottom <= height && about.left >= 0 && about.right <= width,
      JSON.stringify(about),
    );
    await page.touchscreen.tap((about.left + about.right) / 2, (about.top + about.bottom) / 2);
    await page.locator("#about").waitFor();
    await page.done();
  }
});

test("no control moves because the result changed", async () => {
  for (const options of [{}, { viewport: phone, ...touch }]) {
    const page = await browser.open(options);
    await page.evaluate((text) => evenlift.load(text), lShape);
    await idle(page);
    const settings = async () =>
      Object.fromEntries(
        (await mirrored(page))
          .filter(
            ({ card, label }) => card === "Panel" && !label.startsWith("Team ") && !/^Lower the ratio/.test(label),
          )
          .map(({ label, left, top }) => [label, [left, top]]),
      );
    const at = await settings();
    assert.ok(Object.keys(at).length >= (options.viewport ? 4 : 9), Object.keys(at).join(" · ")); // of the closed sheet
    // only its first rows
    for (const change of [
      { teams: 4 },
      { teams: 1 },
      { min_ratio: 1 },
      { min_ratio: 0 },
      { teams: "max" },
      { com: [380, 20], min_ratio: 0.99 },
      { metric: "distributed", teams: 9 },
      { com: null, min_ratio: 0.8, teams: 3, metric: "area" },
    ]) {
      await page.evaluate((settings) => evenlift.set(settings), change);
      await idle(page);
      const now = await settings();
      for (const label of Object.keys(at))
        if (label in now) assert.deepEqual(now[label], at[label], `${label} after ${JSON.stringify(change)}`);
    }
    await page.done();
  }
});

test("where no chord is even enough, one press lowers the ratio to the best that there is", async () => {
  const page = await browser.open();
  await page.evaluate((text) => {
    evenlift.load(text);
    evenlift.set({ com: [330, 190], min_ratio: 1 });
  }, lShape);
  await idle(page);
  assert.equal((await state(page)).teams.length, 0);
  await press(page, "offer");
  await idle(page);
  const { teams, min_ratio: ratio } = await state(page);
  assert.ok(teams.length > 0 && teams[0].ratio >= ratio && teams[0].ratio < ratio + 0.02);
  await page.done();
});

test("as many robots as a capacity needs are one press away", async () => {
  const page = await browser.open();
  await page.evaluate(() => evenlift.set({ capacity: 9 }));
  await idle(page);
  await press(page, "use needed");
  await idle(page);
  const { loads, capacity } = await state(page);
  assert.ok(loads.max <= 9);
  assert.equal(capacity.limit, 9);
  await page.done();
});

test("a robot that is pressed says why it stands there, and leads into the lesson", async () => {
  const page = await browser.open();
  const [x, y] = await page.evaluate(() => {
    const [at] = evenlift.state().teams[1].ends;
    return [...evenlift.view.to_screen(...at)];
  });
  await page.mouse.click(x, y);
  await idle(page);
  assert.match(
    await page.locator("#alert").textContent(),
    /^Team 2: robot [34] of 6\. It carries: .*\skg of 100\skg\..* Load ratio: 0\.\d{3}\. Its chord: number \d+ of \d+ possible\. Team 2 takes the chord that adds the most area to the lifting base: .* It adds an area of \d+; the next best chord would add \d+\.$/,
  );
  await press(page, "show in lesson");
  await idle(page);
  assert.match(await page.locator("#summary").textContent(), /Team 2 takes candidate/);
  await page.done();
});

test("on a phone the card that says why stands below the robot, whichever was tapped", async () => {
  for (const viewport of [phone, { width: 320, height: 568 }]) {
    const page = await browser.open({ viewport, ...touch });
    const robots = (await state(page)).teams.flatMap(({ ends }) => ends);
    const { y: toolbar, height } = await control(page, "Samples");
    let asked = 0;
    for (const robot of robots) {
      const [x, y] = await toScreen(page, robot);
      if (y < toolbar + height + 30) continue;
      await page.touchscreen.tap(x, y);
      await idle(page);
      const close = await control(page, "close explanation");
      assert.ok(close.y > y + 12, `${viewport.width}: the card begins at ${close.y}, the robot is at ${y}`);
      ++asked;
      await page.keyboard.press("Escape"); // the card
      await page.keyboard.press("Escape"); // a selected vertex
      await idle(page);
    }
    assert.ok(asked >= 4, String(asked));
    await page.done();
  }
});

test("the verdict stays in sight while the settings below it scroll", async () => {
  const page = await browser.open();
  const before = await control(page, "failures");
  const settings = await control(page, "teams");
  await openDrawers(page, "Robots");
  await page.mouse.move(settings.x, settings.y + 60);
  await page.mouse.wheel(0, 4000);
  await idle(page);
  const after = await control(page, "failures");
  assert.deepEqual([after.x, after.y], [before.x, before.y]);
  assert.ok((await control(page, "teams")).y < settings.y - 100, "the settings scrolled");
  await page.done();
});

const elementAt = (page, [x, y]) =>
  page.evaluate((at) => document.elementFromPoint(...at).id || document.elementFromPoint(...at).ariaLabel, [x, y]);

test("on a phone a robot's card takes the presses on it, also where a field of the sheet lies below", async () => {
  const page = await browser.open({ viewport: phone, ...touch });
  await set(page, { metric: "balanced", robots: 6 });
  await idle(page);
  const [first] = (await state(page)).robots;
  const [x, y] = await toScreen(page, first.at);
  await page.mouse.click(x, y);
  const fail = await control(page, "fail");
  assert.equal(await elementAt(page, fail.middle), "canvas");
  await press(page, "fail");
  await idle(page);
  await page.waitForFunction(() => document.getElementById("summary").textContent.startsWith("Robot 1 fails: "));
  await page.done();
});

test("above a keyboard the row below the verdict is seen whole, also while one draws", async () => {
  const page = await browser.open({ viewport: { width: 390, height: 500 }, hasTouch: true, isMobile: true });
  await idle(page);
  const teams = await control(page, "teams");
  assert.ok(teams.y + teams.height <= 500, JSON.stringify(teams));
  await page.keyboard.press("d");
  for (const [x, y] of [
    [80, 180],
    [200, 200],
  ]) {
    await page.touchscreen.tap(x, y);
    await idle(page);
  }
  for (const field of await page
    .locator("#mirror")
    .getByLabel(/^(Length|Angle)/)
    .all()) {
    const { y, height } = await field.boundingBox();
    assert.ok(y + height <= 500, `${y} ${height}`);
  }
  assert.equal(
    await page
      .locator("#mirror")
      .getByLabel(/^(Length|Angle)/)
      .count(),
    2,
  );
  await page.done();
});

test("the sheet's handle and headline stay, and no field that scrolls reaches them", async () => {
  const page = await browser.open({ viewport: phone, ...touch });
  await tap(page, "handle");
  const handle = await control(page, "handle"),
    teams = await control(page, "teams");
  for (let scrolled = 0; scrolled < 12; ++scrolled) {
    await page.mouse.move(200, 750);
    await page.mouse.wheel(0, 25);
    await idle(page);
    assert.deepEqual(await control(page, "handle"), handle);
    for (let down = 0; down < 74; down += 4)
      assert.equal(
        await elementAt(page, [handle.middle[0], handle.y + down]),
        "canvas",
        `${down} below the sheet's top`,
      );
  }
  assert.ok((await control(page, "teams")).y < teams.y - 100, "the rest scrolled");
  await page.done();
});

test("the wheel over a value scrolls the panel, and leaves the drawing where it is", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 560 } });
  const before = await toScreen(page, [0, 0]);
  const weight = await control(page, "weight");
  await page.mouse.move(...weight.middle);
  await page.mouse.wheel(0, 120);
  await idle(page);
  assert.ok((await control(page, "weight")).y < weight.y, "the panel scrolled");
  assert.deepEqual(await toScreen(page, [0, 0]), before);
  await page.done();
});

test("a lesson begins at the head of the panel, however far it was scrolled, and beside the drawing on a phone", async () => {
  const page = await browser.open();
  await openDrawers(page, "Robots");
  await idle(page);
  await page.keyboard.press("b");
  const close = await control(page, "leave");
  assert.ok(close.y >= 16 && close.y < 60, String(close.y));
  await page.done();
  const small = await browser.open({ viewport: phone, ...touch });
  await tap(small, "handle");
  await tap(small, "handle");
  await small.keyboard.press("b");
  await idle(small);
  const next = await control(small, "Next step");
  assert.ok(next.y > phone.height * 0.6 && next.y < phone.height - 40, String(next.y));
  await small.done();
});

test("what went well is said for as long as it takes to read it, and what went wrong until it is closed", async () => {
  const page = await browser.open({ hasty: true });
  await page.keyboard.press("Control+c");
  assert.ok(await controlIfShown(page, "close"), "a notice");
  await page.evaluate(() => evenliftTimersRing());
  await idle(page);
  assert.equal(await controlIfShown(page, "close"), null);
  await paste(page, "no polygon");
  assert.match(await noticed(page), /cannot be opened/);
  assert.ok(await controlIfShown(page, "close"), "a problem");
  await page.evaluate(() => evenliftTimersRing());
  await idle(page);
  assert.ok(await controlIfShown(page, "close"), "it stays");
  await page.done();
});

test("a length steps up and down through the same values, whatever the size of the object", async () => {
  const page = await browser.open();
  for (const size of [400, 20, 1.5]) {
    await load(page, `(0,0)\n(${size},0)\n(${size},${size})\n(0,${size})\n`);
    await openDrawers(page, "Object");
    const values = [];
    for (let i = 0; i < 13; ++i) {
      values.push(await heightOfC(page));
      await press(page, "com height +");
      await idle(page);
    }
    assert.equal(new Set(values).size, 13, values.join(" "));
    for (const wanted of values.slice(3).reverse()) {
      await press(page, "com height -");
      await idle(page);
      assert.equal(await heightOfC(page), wanted);
    }
    await set(page, { com_height: 0 });
  }
  await page.done();
});

test("the height of C is set in either of its two drawers", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1300 } });
  await openDrawers(page, "Object", "Carrying");
  const heights = page.locator('#mirror input[aria-label="Height of the centre of mass"]');
  assert.equal(await heights.count(), 2);
  for (const drawer of [0, 1]) {
    const before = Number(await heights.nth(drawer).inputValue());
    const { x, y, width, height } = await heights.nth(drawer).boundingBox();
    await page.mouse.click(x + width + 18, y + height / 2); // its +
    await idle(page);
    for (const each of [0, 1]) assert.ok(Number(await heights.nth(each).inputValue()) > before, `${drawer}, ${each}`);
  }
  await page.done();
});

test("choosing a unit says that no number changes, and sizes have it, too", async () => {
  const page = await browser.open();
  await openDrawers(page, "Object", "Robots");
  await idle(page);
  await page.locator("#mirror select[aria-label='Unit of lengths']").selectOption("mm");
  assert.equal(await noticed(page), "Lengths are now in mm. The numbers stay the same.");
  assert.match(await page.locator("#mirror input[aria-label='Radius of a robot']").inputValue(), /^0\smm$/);
  await page.done();
});

test("a limit is typed where there is none, and a section that is opened comes into view", async () => {
  const page = await browser.open();
  await page.keyboard.press("Y");
  await page.waitForFunction(() =>
    document.activeElement?.getAttribute("aria-label")?.startsWith("Capacity of a robot"),
  );
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal((await state(page)).capacity, undefined, "to look at it sets nothing");
  await type(page, "capacity", "25");
  assert.equal((await state(page)).capacity.limit, 25);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal((await state(page)).capacity, undefined, "it is one step");
  await type(page, "capacity", "25");
  await openDrawers(page, "Robots");
  await idle(page);
  const robots = await control(page, "Robots");
  assert.ok(robots.y < 400, `the drawer’s head is at ${robots.y}`);
  await page.done();
});

test("on a phone on its side the card that says why stands over the panel, and covers nothing of the object", async () => {
  const page = await browser.open({ viewport: { width: 844, height: 390 }, ...touch });
  const { teams, polygon } = await state(page);
  const object = await Promise.all(polygon.map((at) => toScreen(page, at)));
  for (const robot of teams.flatMap(({ ends }) => ends)) {
    await page.mouse.click(...(await toScreen(page, robot)));
    await idle(page);
    const button = await control(page, "show in lesson");
    assert.ok(Math.max(...object.map(([x]) => x)) < button.x - 16, JSON.stringify(button));
    await page.keyboard.press("Escape"); // the card
    await page.keyboard.press("Escape"); // a selected vertex
    await idle(page);
  }
  await page.done();
});

test("a candidate that is pressed says why it was not taken; Esc closes the card", async () => {
  const page = await browser.open();
  await page.evaluate((text) => {
    evenlift.load(text);
    evenlift.set({ overlays: ["candidates"], teams: 1 });
  }, lShape);
  await idle(page);
  const [x, y] = await page.evaluate(() => {
    const { candidates, teams } = evenlift.state();
    const free = candidates.find(({ ends }) => JSON.stringify(ends) !== JSON.stringify(teams[0].ends));
    const [[ax, ay], [bx, by]] = free.ends;
    return [...evenlift.view.to_screen(ax + (bx - ax) * 0.3, ay + (by - ay) * 0.3)];
  });
  // A drag that ends where it began is not a click.
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const away of [60, 0]) {
    await page.mouse.move(x + away, y);
    await idle(page);
  }
  await page.mouse.up();
  await idle(page);
  assert.equal(await controlIfShown(page, "close explanation"), null);
  await page.mouse.click(x, y);
  await idle(page);
  assert.match(await page.locator("#alert").textContent(), /^Candidate \d+ of \d+\. /);
  await control(page, "close explanation");
  await page.keyboard.press("Escape");
  assert.equal(await controlIfShown(page, "close explanation"), null);
  await page.done();
});

test("a tip covers neither the button that it is about nor a neighbour", async () => {
  const page = await browser.open({ drawn: true });
  await page.mouse.move(600, 600);
  const pictures = async (...names) =>
    Promise.all(
      names.map(async (name) => {
        const { x, y, width, height } = await control(page, name);
        return (await page.screenshot({ clip: { x, y, width, height } })).toString("base64");
      }),
    );
  const neighbours = ["Samples", "Undo", "weight", "weight -", "teams", "Zoom in", "Coordinates"];
  const before = await pictures(...neighbours),
    whole = await page.screenshot();
  for (const [x, y] of [
    (await control(page, "Draw")).middle,
    [960, (await control(page, "weight")).middle[1]],
    (await control(page, "Show the whole object")).middle,
  ]) {
    await page.mouse.move(x, y);
    await idle(page);
    assert.ok((await browser.compare(whole, await page.screenshot())).share > 0, "there is a tip");
    assert.deepEqual(await pictures(...neighbours), before, `at ${x}, ${y}`);
  }
  await page.done();
});

test("the pointer says what a press would do", async () => {
  const page = await browser.open();
  await page.evaluate((text) => evenlift.load(text), lShape);
  await idle(page);
  const over = async (x, y) => {
    const [px, py] = await page.evaluate((at) => [...evenlift.view.to_screen(...at)], [x, y]);
    await page.mouse.move(px, py);
    await idle(page);
    return page.evaluate(() => getComputedStyle(document.getElementById("canvas")).cursor);
  };
  assert.equal(await over(400, 150), "grab");
  assert.equal(await over(275, 0.5), "copy");
  assert.equal(await over(-40, -40), "default");
  await page.mouse.down();
  await page.mouse.move(300, 300);
  await idle(page);
  assert.equal(await page.evaluate(() => getComputedStyle(document.getElementById("canvas")).cursor), "grabbing");
  await page.mouse.up();
  await page.keyboard.press("d");
  await page.mouse.move(500, 400);
  await idle(page);
  assert.equal(await page.evaluate(() => getComputedStyle(document.getElementById("canvas")).cursor), "crosshair");
  await page.done();
});

test("zooming has limits, and an object out of view is one press away", async () => {
  const page = await browser.open();
  const width = () =>
    page.evaluate(() => {
      const { polygon } = evenlift.state();
      const xs = polygon.map((p) => evenlift.view.to_screen(...p).x);
      return Math.max(...xs) - Math.min(...xs);
    });
  const fitted = await width();
  for (let i = 0; i < 40; ++i) await page.keyboard.press("-");
  await idle(page);
  const smallest = await width();
  assert.ok(smallest > fitted / 5 && smallest < fitted / 2, `${smallest} of ${fitted}`);
  await page.keyboard.press("0");
  await page.mouse.move(400, 400);
  for (let i = 0; i < 20; ++i) await page.mouse.wheel(0, 300);
  await idle(page);
  const held = await page.evaluate(() => [...evenlift.view.to_world(400, 400)]);
  for (let i = 0; i < 5; ++i) await page.mouse.wheel(0, 300);
  await idle(page);
  const now = await page.evaluate(() => [...evenlift.view.to_world(400, 400)]);
  assert.ok(
    Math.hypot(now[0] - held[0], now[1] - held[1]) < 1e-3,
    `at its limit zooming moves nothing: ${held} ${now}`,
  );
  await page.keyboard.press("0");
  await page.mouse.move(20, 400);
  for (let i = 0; i < 30; ++i) await page.mouse.wheel(0, -300);
  await idle(page);
  await press(page, "show object");
  await idle(page);
  assert.ok(Math.abs((await width()) - fitted) < 1);
  await page.done();
});

test("what is copied is said as it is", async () => {
  const page = await browser.open();
  const said = async () => {
    await page.keyboard.press("Control+c");
    await idle(page);
    return page.locator("#alert").textContent();
  };
  assert.match(await said(), /It holds the polygon and all settings\. It has \d+ characters\.$/);
  await page.evaluate(() => evenlift.set({ loads: "springs" }));
  assert.match(await said(), /It does not hold the choice of loads\. It has \d+ characters\.$/);
  await page.keyboard.press("d");
  await page.mouse.click(500, 400);
  assert.match(await said(), /not closed yet: the link holds the previous one\. It has \d+ characters\.$/);
  await page.done();
});

test("the numbers of the result are there for screen readers", async () => {
  const page = await browser.open();
  await idle(page);
  const texts = await page.locator("#mirror p").allTextContents();
  for (const wanted of ["Coverage: 96.0\u00a0%", "Spread of loads: 0.5 kg", "Form closure: yes"])
    assert.ok(
      texts
        .map((text) => text.replaceAll("\u202f", " ").replaceAll("\u2009", " "))
        .some((text) => text.replace(/\s/g, " ") === wanted.replace(/\s/g, " ")),
      `${wanted} in ${texts}`,
    );
  const row = page.locator("#mirror").getByRole("button", { name: /^Team 2,/ });
  assert.match(
    await row.getAttribute("aria-label"),
    /^Team 2, robots 3 and 4: loads 16\.9 and 16\.4 kg, length \d+, ratio 0\.972\. Why here\?$/,
  );
  await openDrawers(page, "Robots");
  assert.equal(await field(page, "Capacity of a robot, in kg").inputValue(), "no limit");
  await page.done();
});

test("a refusal is told again when it comes again", async () => {
  const page = await browser.open();
  await idle(page);
  await page.evaluate(() => {
    globalThis.told = [];
    new MutationObserver(() => globalThis.told.push(document.getElementById("alert").textContent.trim())).observe(
      document.getElementById("alert"),
      { childList: true, characterData: true, subtree: true },
    );
  });
  for (const wrong of ["abc", "-5"]) {
    await press(page, "weight");
    await page.keyboard.type(wrong);
    await page.keyboard.press("Enter");
    await idle(page);
  }
  const told = (await page.evaluate(() => globalThis.told)).filter(Boolean);
  assert.equal(told.length, 2, told.join(" | "));
  assert.equal(told[0], told[1]);
  await page.done();
});

test("what is selected and shown is told, and no more than that", async () => {
  const page = await browser.open();
  await page.evaluate((text) => evenlift.load(text), lShape);
  await idle(page);
  await page.evaluate(() => {
    globalThis.said = [];
    const seen = (records) =>
      records.forEach(({ target, addedNodes }) => {
        const element = (target.nodeType === 1 ? target : target.parentElement).closest("span");
        for (const each of [element, ...addedNodes])
          if (each?.nodeType === 1 && each.ariaLive !== "off") globalThis.said.push(each.textContent);
      });
    for (const id of ["summary", "news"])
      new MutationObserver(seen).observe(document.getElementById(id), {
        childList: true,
        characterData: true,
        subtree: true,
      });
  });
  await page.focus("#canvas");
  await page.keyboard.press("v");
  await idle(page);
  await page.keyboard.press("a");
  await idle(page);
  await page.keyboard.press("h");
  await idle(page);
  assert.deepEqual(await page.evaluate(() => globalThis.said), [
    "Vertex 1 of 6, (0.0, 0.0).",
    "Shown: candidates.",
    "Hidden: the lifting base.",
  ]);
  await page.done();
});

test("while the pointer rests on a row of the table, nothing more is drawn", async () => {
  const page = await browser.open({ hasty: true, viewport: { width: 1280, height: 1400 } });
  await load(page, asset("violin"));
  for (const [settings, row] of [
    [{ metric: "area", teams: 3 }, "Team 2"],
    [{ metric: "balanced", robots: 5 }, "Robot 2"],
  ]) {
    await set(page, settings);
    const { middle } = await control(page, row);
    await page.mouse.move(...middle);
    await drawsNothing(page);
  }
  await page.done();
});

test("a key that asks for a field before the controls are there opens it when they come", async () => {
  const page = await browser.open();
  let comes;
  const asked = new Promise((done) => {
    comes = done;
  });
  await page.route("**/mirror.js", async (route) => {
    await asked;
    await route.continue();
  });
  await page.reload();
  await page.evaluate(() => evenlift.ready);
  assert.equal(await page.locator("#mirror input").count(), 0);
  await page.keyboard.press("y");
  comes();
  await page.waitForFunction(() => document.activeElement?.getAttribute("aria-label")?.startsWith("Weight"));
  await page.done();
});

test("every candidate is asked for by the word on the button, too", async () => {
  const page = await browser.open();
  await load(page, asset("arrow"));
  const teams = page.locator("#mirror").getByRole("textbox", { name: "Teams" });
  await teams.fill("All");
  await teams.press("Enter");
  await idle(page);
  const { candidates, teams: placed } = await state(page);
  assert.equal(placed.length, candidates.length);
  await page.done();
});

test("whoever came to a number by Tab stays there after Enter, and others are back at the drawing", async () => {
  const page = await browser.open();
  await idle(page);
  const focus = () =>
    page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute("aria-label"));
  await page.keyboard.press("y");
  const name = await focus();
  await page.keyboard.type("231");
  await page.keyboard.press("Enter");
  assert.equal(await focus(), "canvas");
  for (let i = 0; i < 60 && (await focus()) !== name; ++i) await page.keyboard.press("Tab");
  await page.keyboard.type("437");
  await page.keyboard.press("Enter");
  assert.equal(await focus(), name);
  await idle(page);
  assert.equal((await state(page)).weight, 437);
  await page.done();
});

test("undo and redo work from every control of the panel, but not while one types", async () => {
  const page = await browser.open();
  const choose = async (label) => {
    await page.locator(`#mirror [aria-label="${label}"]`).focus();
    await idle(page);
  };
  const metric = async () => (await state(page)).metric;
  await choose("Method");
  await page.keyboard.press("ArrowDown");
  await idle(page);
  assert.equal(await metric(), "circle");
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal(await metric(), "area");
  await page.keyboard.press("Control+y");
  await idle(page);
  assert.equal(await metric(), "circle");
  await choose("Weight in kg");
  await page.keyboard.press("ArrowUp");
  await idle(page);
  assert.equal((await state(page)).weight, 110);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal((await state(page)).weight, 100);
  assert.equal(await field(page, "Weight in kg").inputValue(), "100", "it is typed over anew");
  await page.keyboard.type("55");
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal(await metric(), "circle", "what is typed has an undo of its own");
  await page.done();
});

test("what is typed over is exact, however it is shown", async () => {
  const page = await browser.open();
  const centre = [560.123456, 250.256789];
  await page.evaluate((com) => evenlift.set({ com, weight: 437.123456789 }), centre);
  await press(page, "com");
  const typed = field(page, "Centre of mass, x and y");
  assert.equal(await typed.inputValue(), "560.123456, 250.256789");
  await typed.fill("561.123456, 250.256789");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.deepEqual((await state(page)).centre_of_mass, [561.123456, 250.256789]);
  await page.keyboard.press("Control+z");
  assert.equal(await noticed(page), "Undone: moved the centre of mass.");
  await press(page, "weight");
  assert.equal(await field(page, "Weight in kg").inputValue(), "437.123456789");
  await page.done();
});

test("a button that has done its work keeps the focus", async () => {
  const page = await browser.open();
  await set(page, { capacity: 10 });
  await openDrawers(page, "Robots");
  const needed = page.locator('#mirror button[aria-label^="Use "]');
  await needed.focus();
  await page.keyboard.press("Enter");
  await idle(page);
  const now = () =>
    page.evaluate(() => [
      document.activeElement.ariaLabel,
      document.activeElement.getAttribute("aria-disabled"),
      document.activeElement.disabled,
    ]);
  assert.deepEqual(await now(), ["Use the number needed", "true", false]);
  await page.keyboard.press("Tab");
  assert.equal(await page.locator('#mirror [aria-label="Use the number needed"]').isDisabled(), true);
  await page.done();
});
