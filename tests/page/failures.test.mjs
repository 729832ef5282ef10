import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  control,
  controlIfShown,
  drag,
  evenlift,
  fragment,
  idle,
  link,
  load,
  openDrawers,
  press,
  program,
  published,
  reload,
  set,
  sharedBrowser,
  state,
  summary,
  tap,
  thrown,
  toScreen,
} from "./browser.mjs";

const browser = sharedBrowser();

const robotAt = (now, robot) => now.teams.flatMap(({ ends }) => ends)[robot];

test("a robot is let fail from its card, and works again by its button, Esc or a press on the ground", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const before = await state(page);
  const ways = [() => press(page, "fail"), () => page.keyboard.press("Escape"), () => page.mouse.click(40, 400)];
  for (const back of ways) {
    await page.mouse.click(...(await toScreen(page, robotAt(before, 2))));
    await press(page, "fail");
    await idle(page);
    assert.match(await summary(page), /^Robot 3 fails: the other five carry the object, at most \d+\.\d\skg each\./);
    assert.doesNotMatch(await page.locator("#alert").textContent(), /fails/, "it is told once");
    assert.deepEqual((await state(page)).failures, program("grand-piano", "--failures").failures);
    await back();
    await idle(page);
    assert.match(await summary(page), /^6 robots carry/);
    assert.deepEqual(await state(page), before);
    await page.keyboard.press("Escape");
  }
  await page.done();
});

test("set() lets a robot fail, and refuses one that there is not", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const before = await link(page);
  for (const metric of ["area", "circle", "distance", "distributed", "random", "balanced"]) {
    await set(page, { metric });
    await idle(page);
    await set(page, { failed: 3 });
    await idle(page);
    assert.match(await summary(page), /^Robot 3 fails: /, metric);
    assert.equal((await state(page)).failures.length, 6);
    await set(page, { failed: null });
    await idle(page);
    assert.doesNotMatch(await summary(page), /fails/);
  }
  await set(page, { metric: "area" });
  assert.equal(await link(page), before, "no link holds it");
  assert.match(await thrown(page, "set", { failed: 7 }), /^failed: there is no robot 7: there are 6/);
  assert.match(await thrown(page, "set", { teams: 2, failed: 5 }), /^failed: there is no robot 5: there are 4/);
  assert.equal((await state(page)).teams.length, 3, "nothing has changed");
  for (const failed of [0, -1, 1.5, "3", true])
    assert.match(await thrown(page, "set", { failed }), /^The failed robot/, String(failed));
  await set(page, { failed: 2 });
  await set(page, { teams: 2 });
  await idle(page);
  assert.doesNotMatch(await summary(page), /fails/, "a change of settings brings it back");
  await page.done();
});

test("the row of signs lets robots fail by a press, by sliding and by keys", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const row = await control(page, "failures");
  const y = row.y + row.height / 2,
    x = (robot) => row.x + (row.width * (robot + 0.5)) / 6;
  await page.mouse.click(x(3), y);
  await idle(page);
  assert.match(await summary(page), /^Robot 4 fails/);
  await page.mouse.click(x(3), y);
  await idle(page);
  assert.match(await summary(page), /^6 robots/);
  await page.mouse.move(x(0), y);
  await page.mouse.down();
  await page.mouse.move(x(1), y, { steps: 4 });
  await page.mouse.move(x(5), y, { steps: 4 });
  await page.mouse.up();
  await idle(page);
  assert.match(await summary(page), /^Robot 6 fails/);
  const slider = page.locator('#mirror [aria-label="The robot that fails"]');
  assert.match(await slider.getAttribute("aria-valuetext"), /^Robot 6 fails/);
  await slider.focus();
  await page.keyboard.press("ArrowLeft");
  await idle(page);
  assert.match(await summary(page), /^Robot 5 fails/);
  await page.keyboard.press("Escape");
  await idle(page);
  assert.match(await summary(page), /^6 robots/);
  await page.done();
});

test("nothing in the panel moves because a robot fails", async () => {
  const page = await browser.open();
  await load(page, asset("letter-e"));
  await set(page, { teams: 2 });
  await idle(page);
  const places = async () =>
    Object.fromEntries(
      await Promise.all(
        ["failures", "methods", "teams +", "Team 1", "Robots"].map(async (name) => [name, await control(page, name)]),
      ),
    );
  const before = await places();
  for (const failed of [1, 2, 3, 4, null]) {
    await set(page, { failed });
    await idle(page);
    assert.deepEqual(await places(), before, String(failed));
  }
  await page.done();
});

test("capacity, doubt and halo are in links, in undo and there after a reload", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await set(page, { capacity: 30, com_radius: 12.5 });
  await page.keyboard.press("Shift+C");
  await idle(page);
  await published(page);
  assert.match(await fragment(page), /^2\./);
  const before = await state(page);
  const { overlays, ...results } = before;
  assert.equal(overlays.halo, true);
  assert.deepEqual(results, program("grand-piano", "--capacity", "30", "--com-radius", "12.5"));
  assert.match(await page.locator("#news").textContent(), /Shown: the tipping distance\./);
  await reload(page);
  assert.deepEqual(await state(page), before);
  assert.equal(await page.locator("#news").textContent(), "", "what holds from the start is not told");
  assert.deepEqual(JSON.parse(evenlift("place", await link(page), "--json", "--candidates")), before);
  await page.keyboard.press("Shift+C");
  await set(page, { capacity: null, com_radius: 0 });
  await published(page);
  assert.match(await fragment(page), /^1\./);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal((await state(page)).capacity.limit, 30);
  await page.done();
});

test("the ring of the halo is dragged, and is one step of undo", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  await openDrawers(page, "Show"); // a number of the result has the same name
  await press(page, "Tipping distance");
  await idle(page);
  const centre = await toScreen(page, (await state(page)).centre_of_mass);
  const grip = [centre[0] + 28 * Math.SQRT1_2, centre[1] - 28 * Math.SQRT1_2];
  await drag(page, grip, [grip[0] + 40, grip[1] - 40], 8);
  await idle(page);
  const { robustness } = await state(page);
  assert.ok(robustness.com_radius > 0);
  assert.match(await summary(page), /If C is off by up to [\d.]+, the loads of equally stiff robots change by up to/);
  await page.keyboard.press("Control+z");
  await idle(page);
  assert.equal((await state(page)).robustness.com_radius, undefined);
  await page.done();
});

test("which loads are shown, how well C is known, and what balanced robots keep are set in the panel", async () => {
  const page = await browser.open({ viewport: { width: 1280, height: 1300 } });
  await load(page, asset("grand-piano"));
  await set(page, { metric: "balanced" });
  await idle(page);
  await press(page, "loads");
  await press(page, "At worst");
  await idle(page);
  assert.match(
    await summary(page),
    /On level ground and with C as given, a robot may have to carry up to [\d.]+\skg if heights are unequal or the object bends\./,
  );
  await press(page, "survive +");
  await idle(page);
  assert.equal((await state(page)).survive, 1);
  await press(page, "apart");
  await page.keyboard.type("40");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).apart, 40);
  await press(page, "usual apart");
  await idle(page);
  assert.equal((await state(page)).apart, null);
  await page.keyboard.press("Shift+E");
  await idle(page);
  await page.keyboard.type("15");
  await page.keyboard.press("Enter");
  await idle(page);
  assert.equal((await state(page)).robustness.com_radius, 15);
  await set(page, { loads: "plan" });
  assert.match(await thrown(page, "set", { loads: "most" }), /^The load model must be/);
  assert.match(await thrown(page, "set", { com_radius: -1 }), /^The uncertainty of the centre of mass/);
  await page.done();
});

test("under a finger each of many robots can be reached by buttons of a finger's size", async () => {
  const page = await browser.open({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  await load(page, asset("grand-piano"));
  await set(page, { teams: 3 });
  assert.equal(await controlIfShown(page, "failure +"), null, "six signs are large enough themselves");
  const before = await control(page, "teams +");
  await set(page, { teams: 4 });
  for (const name of ["failure -", "failure +"]) {
    const { width, height } = await control(page, name);
    assert.ok(Math.min(width, height) >= 44, `${name}: ${width} by ${height}`);
  }
  assert.deepEqual(await control(page, "teams +"), before, "nothing moves for them");
  for (let robot = 1; robot <= 8; ++robot) {
    await tap(page, "failure +");
    await idle(page);
    assert.match(await summary(page), new RegExp(`^Robot ${robot} fails`));
  }
  for (let robot = 7; robot >= 1; --robot) await tap(page, "failure -");
  await tap(page, "failure -");
  await idle(page);
  assert.match(await summary(page), /^8 robots/);
  await page.done();
});
