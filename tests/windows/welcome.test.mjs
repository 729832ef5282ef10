import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  control,
  idle,
  link,
  load,
  reload,
  set,
  sharedBrowser,
  state,
  tap,
  thrown,
  toScreen,
} from "../page/browser.mjs";
import { allClosed, openWindow, violations } from "../page/windows.mjs";

const browser = sharedBrowser();

const card = (page) => page.locator("#welcome");
const box = (page, selector) =>
  page.locator(selector).evaluate((e) => {
    const { left, top, right, bottom } = e.getBoundingClientRect();
    return { left, top, right, bottom };
  });
const apart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;

test("a link in a language is for newcomers, too; an embedded page or a challenge is not", async () => {
  for (const [address, comes] of [
    ["?lang=de", true],
    ["?place=4", false],
  ]) {
    const page = await browser.open({ first: true, address });
    await idle(page);
    assert.equal(await card(page).count(), comes ? 1 : 0, address);
    await page.done();
  }
});

test("the first Tab leads to the card's first button", async () => {
  const page = await browser.open({ first: true });
  await card(page).waitFor();
  await idle(page);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Place robots yourself");
  await page.done();
});

for (const [width, height, touch] of [
  [320, 568, true],
  [390, 844, true],
  [740, 360, true],
  [844, 390, true],
  [1024, 768, false],
  [820, 1180, true],
  [1440, 900, false],
  [3840, 2160, false],
]) {
  test(`at ${width} by ${height} the card covers neither the object nor a control`, async () => {
    const page = await browser.open({ first: true, viewport: { width, height }, hasTouch: touch, isMobile: touch });
    await idle(page);
    await card(page).waitFor();
    await idle(page);
    const place = await box(page, "#welcome");
    assert.ok(
      place.left >= 0 && place.top >= 0 && place.right <= width && place.bottom <= height,
      JSON.stringify(place),
    );
    const things = await page.evaluate(() => {
      const state = evenlift.state();
      const points = [
        ...state.teams.flatMap(({ ends }) => ends),
        ...evenlift.text().matchAll(/^\(([^,]+),([^)]+)\)/gm),
      ].map((p) => evenlift.view.to_screen(Number(p.at(-2)), Number(p.at(-1))));
      const controls = [
        "Samples",
        "Draw",
        "Undo",
        "Copy link",
        "Zoom in",
        "Show the whole object",
        "Coordinates",
        "teams +",
        "teams -",
        "ratio",
      ]
        .map((name) => evenlift.view.control(name))
        .filter(Boolean);
      return [
        {
          left: Math.min(...points.map((p) => p.x)) - 12,
          right: Math.max(...points.map((p) => p.x)) + 12,
          top: Math.min(...points.map((p) => p.y)) - 12,
          bottom: Math.max(...points.map((p) => p.y)) + 12,
        },
        ...controls.map(({ x, y, width: w, height: h }) => ({ left: x, top: y, right: x + w, bottom: y + h })),
      ];
    });
    assert.ok(things.length > 6);
    for (const thing of things)
      assert.ok(apart(place, thing), `${JSON.stringify(place)} covers ${JSON.stringify(thing)}`);
    const [one, other] = await page.evaluate(() =>
      evenlift.state().teams[0].ends.map((at) => [...evenlift.view.to_screen(...at)]),
    );
    const between = Math.hypot(one[0] - other[0], one[1] - other[1]);
    assert.ok(between >= 84, `the object is to be seen between its robots: ${between} pixels`);
    const sentence = await box(page, "#welcome p");
    assert.ok(sentence.bottom - sentence.top < 80, "the sentence is no column of words");
    const targets = await page
      .locator("#welcome button")
      .evaluateAll((all) => all.map((b) => b.getBoundingClientRect().height));
    if (touch) assert.ok(Math.min(...targets) >= 44, String(targets));
    assert.equal(
      await page.evaluate(
        () => document.activeElement.id !== "welcome" && document.activeElement.closest("#welcome") === null,
      ),
      true,
      "it takes no focus",
    );
    await page.done();
  });
}

test("the card is told, and a list of the panels that would be under it is seen", async () => {
  for (const [width, height] of [
    [320, 568],
    [390, 844],
  ]) {
    const page = await browser.open({ first: true, viewport: { width, height }, hasTouch: true, isMobile: true });
    await card(page).waitFor();
    await idle(page);
    assert.match(await page.locator("#alert").textContent(), /^How to begin: /);
    await tap(page, "more");
    await idle(page);
    assert.equal(await card(page).isVisible(), false);
    await page.keyboard.press("Escape");
    await idle(page);
    assert.equal(await card(page).isVisible(), true);
    await page.done();
  }
});

test("the card goes with the first edit, and does not come back", async () => {
  const page = await browser.open({ first: true });
  await idle(page);
  await card(page).waitFor();
  await set(page, { teams: 2 });
  await idle(page);
  assert.equal(await card(page).count(), 0);
  await reload(page);
  assert.equal(await card(page).count(), 0);
  await page.done();
});

test("the card goes when one begins to draw", async () => {
  const page = await browser.open({ first: true });
  await card(page).waitFor();
  await page.locator("#canvas").focus();
  await page.keyboard.press("d");
  await card(page).waitFor({ state: "detached" });
  await page.done();
});

test("closed without an edit, it does not come back either; its key brings it back, with the focus", async () => {
  const page = await browser.open({ first: true });
  await idle(page);
  await page.getByRole("region", { name: "How to begin" }).getByRole("button", { name: "Close" }).click();
  assert.equal(await card(page).count(), 0);
  await reload(page);
  assert.equal(await card(page).count(), 0);
  await page.locator("#canvas").focus();
  await page.keyboard.press("W");
  await card(page).waitFor();
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Place robots yourself");
  await page.keyboard.press("Escape");
  await idle(page);
  assert.equal(await card(page).count(), 0);
  assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
  await page.done();
});

test("there is no card for those who follow a link, or see a figure in an article, or come for a lesson", async () => {
  const shared = "1.Pq1riQoPLvUJmF2ykWfnDSNVxm2W3yqqGl2Hz55vK9StSPd";
  for (const address of [`#${shared}`, `?embed=1#${shared}`, "?embed=1", "?lesson=moved"]) {
    const page = await browser.open({ first: true, address });
    await idle(page);
    assert.equal(await card(page).count(), 0, address);
    await page.done();
  }
});

test("the ways to begin: drawing, the gallery, the tour", async () => {
  const page = await browser.open({ first: true });
  await idle(page);
  await card(page).getByRole("button", { name: "Draw your own" }).click();
  await idle(page);
  assert.equal(await card(page).count(), 0);
  for (const at of [
    [300, 300],
    [500, 300],
    [400, 500],
  ])
    await page.mouse.click(...at);
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal(
    await page.evaluate(() => evenlift.text().trim().split("\n").length),
    3,
    "clicks draw, and the keys are the canvas's",
  );
  await page.keyboard.press("W");
  await card(page).getByRole("button", { name: "Choose a sample" }).click();
  await page.locator("#samples .sample").first().waitFor();
  await page.keyboard.press("Escape");
  await allClosed(page);
  await page.keyboard.press("W");
  await card(page).getByRole("button", { name: "Take the tour" }).click();
  await page.locator("#tour").waitFor();
  await page.done();
});

const tour = (page) => page.locator("#tour");
const ringed = (page) =>
  page.locator(".tour-rings > *").evaluateAll((all) =>
    all.map((e) => {
      const { left, top, right, bottom } = e.getBoundingClientRect();
      return { kind: e.localName, left, top, right, bottom };
    }),
  );

async function takeTour(page) {
  await page.locator("#canvas").focus();
  await page.keyboard.press("W");
  await card(page).getByRole("button", { name: "Take the tour" }).click();
  await tour(page).waitFor();
  await idle(page);
  return Number(/of (\d+)/.exec(await tour(page).textContent())[1]);
}

// The current stop, with its text.
async function stop(page) {
  await idle(page);
  return {
    title: await page.locator("#tour-title").textContent(),
    words: await page.locator("#tour-words").textContent(),
  };
}

async function goToStop(page, title) {
  while ((await stop(page)).title !== title) await tour(page).getByRole("button", { name: "Next" }).click();
}

for (const [width, height] of [
  [1280, 800],
  [390, 844],
  [844, 390],
  [320, 568],
  [1920, 1080],
]) {
  test(`the tour at ${width} by ${height}: it covers nothing that it speaks of, its button stays, and keys lead through it`, async () => {
    const touch = width < 900;
    const page = await browser.open({
      viewport: { width, height },
      hasTouch: touch,
      isMobile: touch,
      reducedMotion: "reduce",
    });
    await load(page, asset("horseshoe"));
    await idle(page);
    const before = await link(page);
    const count = await takeTour(page);
    assert.ok(count >= 6 && count <= 9, String(count));
    const seats = new Set(),
      drawings = new Set(),
      titles = [];
    for (let i = 0; i < count; ++i) {
      titles.push((await stop(page)).title);
      const place = await box(page, "#tour");
      assert.ok(
        place.left >= 0 && place.top >= 0 && place.right <= width && place.bottom <= height,
        `stop ${i + 1}: ${JSON.stringify(place)}`,
      );
      seats.add(JSON.stringify([place, await box(page, "#tour .primary")]));
      drawings.add(JSON.stringify(await toScreen(page, [0, 0])));
      const robots = await page.evaluate(() =>
        evenlift
          .state()
          .teams.flatMap(({ ends }) => ends)
          .map((at) => [...evenlift.view.to_screen(...at)]),
      );
      for (const [x, y] of robots)
        assert.ok(
          apart(place, { left: x - 10, right: x + 10, top: y - 10, bottom: y + 10 }),
          `stop ${i + 1} covers a robot at ${[x, y]}`,
        );
      const rings = await ringed(page);
      assert.ok(rings.length > 0, `stop ${i + 1} points at nothing`);
      for (const ring of rings) {
        assert.ok(apart(place, ring), `stop ${i + 1} covers what it points at: ${JSON.stringify(ring)}`);
        assert.ok(
          ring.left >= 0 && ring.top >= 0 && ring.right <= width && ring.bottom <= height,
          `stop ${i + 1} points out of the window: ${JSON.stringify(ring)}`,
        );
      }
      assert.match(await tour(page).textContent(), new RegExp(`${i + 1} of ${count}`));
      if (i === 1) {
        await page.keyboard.press("ArrowLeft");
        assert.equal((await stop(page)).title, titles[0]);
        await page.keyboard.press("ArrowRight");
      }
      await page.keyboard.press("Enter"); // Next has the focus
    }
    await idle(page);
    assert.equal(await tour(page).count(), 0);
    assert.deepEqual(await ringed(page), []);
    assert.equal(seats.size, 1, [...seats].join(" "));
    assert.equal(drawings.size, 1, "the drawing stands still");
    assert.equal(new Set(titles).size, count);
    assert.equal(await page.evaluate(() => document.activeElement.id), "canvas");
    assert.equal(await link(page), before);
    await page.done();
  });
}

test("the two discs of a team have a ring each; the vertex that is ringed is clear of robots, and so is C", async () => {
  const page = await browser.open();
  for (const name of ["puzzle-piece", "horseshoe", "thesis-sample", "violin"]) {
    await load(page, asset(name));
    await takeTour(page);
    const middle = ({ left, right, top, bottom }) => [(left + right) / 2, (top + bottom) / 2];
    const far = ([x, y], [u, v]) => Math.hypot(x - u, y - v);
    const { teams, polygon, centre_of_mass: centre } = await state(page);
    const robots = await Promise.all(teams.flatMap(({ ends }) => ends).map((at) => toScreen(page, at)));
    const rings = await ringed(page);
    assert.equal(rings.length, 2);
    rings.forEach((ring, i) => assert.ok(far(middle(ring), [...robots[i]]) < 1, name));
    await goToStop(page, "The shape");
    const now = await Promise.all(teams.flatMap(({ ends }) => ends).map((at) => toScreen(page, at)));
    const corners = await Promise.all(polygon.map((at) => toScreen(page, at)));
    const [vertex, c] = await ringed(page);
    assert.ok(far(middle(c), await toScreen(page, centre)) < 1);
    assert.ok(Math.min(...corners.map((at) => far(middle(vertex), at))) < 1, "it is a vertex");
    for (const robot of now) assert.ok(far(middle(vertex), robot) > 30, `${name}: ${JSON.stringify(robot)}`);
    await page.keyboard.press("Escape");
    await idle(page);
  }
  await page.done();
});

test("the tour says of each placement what is free to move, and speaks of hatching only where there is some", async () => {
  const page = await browser.open();
  for (const [name, words] of [
    ["puzzle-piece", /^Here it cannot/],
    ["horseshoe", /^Hatching shows .* clockwise in red, counter-clockwise in blue\. The arrow/],
  ]) {
    await load(page, asset(name));
    await takeTour(page);
    await goToStop(page, "Can it still move?");
    assert.match((await stop(page)).words, words, name);
    const { free } = await page.evaluate(() => evenlift.state().closure);
    assert.equal(free.length > 0, name === "horseshoe");
    await page.keyboard.press("Escape");
    await idle(page);
  }
  // It follows the placement, even while it is shown.
  await takeTour(page);
  await goToStop(page, "Can it still move?");
  await load(page, asset("puzzle-piece"));
  assert.match((await stop(page)).words, /^Here it cannot/);
  await page.done();
});

test("during a lesson the tour points at nothing that the lesson has not drawn", async () => {
  const page = await browser.open();
  await page.locator("#canvas").focus();
  await page.keyboard.press("b");
  await page.keyboard.press("Home");
  const about = await openWindow(page, "about");
  await about.getByRole("button", { name: "Take the tour" }).click();
  await tour(page).waitFor();
  const first = await stop(page);
  assert.equal(first.title, "Settings");
  await page.done();
});

test("with balanced robots the tour speaks of them", async () => {
  const page = await browser.open();
  await set(page, { metric: "balanced", robots: 5 });
  await takeTour(page);
  assert.match((await stop(page)).words, /^Each disc is a robot\./);
  assert.equal((await ringed(page)).length, 5);
  await goToStop(page, "Settings");
  assert.match((await stop(page)).words, /number of robots/);
  await page.done();
});

test("a control that the panel has scrolled away is brought back by the stop that points at it", async () => {
  const page = await browser.open({ viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true });
  const seen = async (name) => {
    const { y, height } = await page.evaluate((n) => evenlift.view.control(n), name);
    return y >= 0 && y + height <= 390;
  };
  await idle(page);
  await page.mouse.move(740, 300);
  await page.mouse.wheel(0, 4000);
  await idle(page);
  assert.equal(await seen("teams +"), false);
  await takeTour(page);
  await goToStop(page, "Settings");
  assert.equal(await seen("teams +"), true);
  await page.done();
});

test("a card that becomes higher, as when its font has come, keeps its foot where it is", async () => {
  const page = await browser.open({ first: true, reducedMotion: "reduce" });
  await idle(page);
  await card(page).waitFor();
  const before = await box(page, "#welcome");
  await page.locator("#welcome p").evaluate((words) => {
    words.style.fontSize = "30px";
  });
  await page.waitForFunction(
    ([top, bottom]) => {
      const now = document.getElementById("welcome").getBoundingClientRect();
      return now.top < top - 20 && Math.abs(now.bottom - bottom) < 1;
    },
    [before.top, before.bottom],
  );
  await page.done();
});

test("card and tour have no fault that axe finds, light and dark", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await browser.open({ first: true, colorScheme, reducedMotion: "reduce" });
    await idle(page);
    await card(page).waitFor();
    assert.deepEqual(await violations(page), [], `the card, ${colorScheme}`);
    await card(page).getByRole("button", { name: "Take the tour" }).click();
    await page.locator("#tour").waitFor();
    assert.deepEqual(await violations(page), [], `the tour, ${colorScheme}`);
    await page.done();
  }
});

test("Escape leaves the tour, and nothing moves for those who asked for less motion", async () => {
  const page = await browser.open({ reducedMotion: "reduce" });
  await idle(page);
  await page.keyboard.press("W");
  assert.equal(await card(page).evaluate((root) => root.getAnimations({ subtree: true }).length), 0);
  await card(page).getByRole("button", { name: "Take the tour" }).click();
  await page.locator("#tour").getByRole("button", { name: "Next" }).click();
  assert.equal(
    await page.evaluate(
      () => document.getAnimations().filter((a) => a.effect.target.closest("#tour, .tour-rings")).length,
    ),
    0,
  );
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#tour").count(), 0);
  assert.equal(await thrown(page, "set", { teams: 2 }), undefined);
  await page.done();
});

for (const [width, height] of [
  [390, 844],
  [320, 568],
]) {
  test(`at ${width} by ${height} a card stands whole below a sheet that is pulled up to the top`, async () => {
    const page = await browser.open({ viewport: { width, height }, hasTouch: true, isMobile: true, first: true });
    await page.locator("#welcome").waitFor();
    await idle(page);
    const pullUp = async () => {
      for (let presses = 0; presses < 2 && (await control(page, "handle")).y > 120; ++presses) {
        await tap(page, "handle");
        await idle(page);
      }
    };
    const stands = async (name) => {
      const card = await page.locator(name).boundingBox(),
        handle = await control(page, "handle");
      assert.ok(card.height > 80 && card.y + card.height <= height, `${name}: ${JSON.stringify(card)}`);
      assert.ok(card.y > height / 2 && handle.y < 120, `${name} is below the verdict`);
      const spilt = await page
        .locator(`${name} *`)
        .evaluateAll(
          (all, { y, height: high }) =>
            all
              .map((one) => one.getBoundingClientRect())
              .filter((box) => box.height > 0 && (box.top < y - 1 || box.bottom > y + high + 1)).length,
          card,
        );
      assert.equal(spilt, 0, `nothing of ${name} is beside it`);
    };
    await pullUp();
    await stands("#welcome");
    await page.getByRole("button", { name: /tour/ }).tap();
    await page.locator("#tour").waitFor();
    await pullUp();
    await stands("#tour");
    await page.locator("#tour").getByRole("button", { name: "Skip" }).tap();
    await tap(page, "handle");
    await page.done();
  });
}
