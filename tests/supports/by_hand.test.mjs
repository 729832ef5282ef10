// Dragged from any method, in undo and links, removed, and evened out.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  asset,
  drag,
  evenlift,
  idle,
  link,
  load,
  phone,
  published,
  reload,
  set,
  sharedBrowser,
  state,
  toScreen,
  undo,
} from "../page/browser.mjs";

const browser = sharedBrowser();

// Drags a robot by a part of its way to C.
async function inwards(page, robot, part) {
  const { robots, centre_of_mass: centre } = await state(page);
  const at = robots[robot].at;
  const to = at.map((value, axis) => value + part * (centre[axis] - value));
  await drag(page, await toScreen(page, at), await toScreen(page, to));
  await idle(page);
  return state(page);
}

test("a dragged robot of any method takes all over, and one undo brings the method back", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  for (const metric of ["area", "circle", "distributed", "random"]) {
    await set(page, { metric });
    await idle(page);
    const before = await state(page);
    const after = await inwards(page, 1, 0.4);
    assert.equal(after.metric, "given", metric);
    assert.equal(after.robots.length, before.robots.length);
    assert.equal(after.robots[1].place, "beneath");
    await undo(page);
    assert.deepEqual(await state(page), before, metric);
  }
  await page.done();
});

test("what is placed by hand is the program's own result, from a link and after a reload", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const placed = await inwards(page, 0, 0.3);
  const shared = await link(page);
  assert.deepEqual(JSON.parse(evenlift("place", shared, "--json", "--candidates")), placed);
  await published(page);
  await reload(page);
  assert.deepEqual(await state(page), placed);
  await page.done();
});

test("a robot let go outside the object is taken away; even out makes all loads equal", async () => {
  const page = await browser.open();
  await load(page, asset("grand-piano"));
  const before = await inwards(page, 2, 0.3);
  await drag(page, await toScreen(page, before.robots[0].at), [20, 700]);
  await idle(page);
  const after = await state(page);
  assert.equal(after.robots.length, before.robots.length - 1);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Shift+Q");
  await idle(page);
  assert.ok((await state(page)).loads.spread < 1e-6);
  await page.done();
});

test("what a dragged vertex leaves outside stays with its number, in the link and for the program", async () => {
  const page = await browser.open();
  await load(page, "(0,0)\n(400,0)\n(400,300)\n(0,300)\n");
  await set(page, { supports: "400,75@40 100,300 0,150 350,250 60,40" });
  await idle(page);
  await drag(page, await toScreen(page, [400, 300]), await toScreen(page, [220, 190]));
  await idle(page);
  const after = await state(page);
  assert.deepEqual(after.left_out, [{ kind: "support", index: 3, in_hole: null }]);
  assert.deepEqual(
    after.robots.map(({ support }) => support),
    [0, 1, 2, 4],
  );
  assert.match(after.verdict.reasons.join(" "), /Robot 4 is outside the object: it carries nothing\./);
  const shared = await link(page);
  assert.deepEqual(JSON.parse(evenlift("place", shared, "--json", "--candidates", "--keep-misfits")), after);
  assert.throws(() => evenlift("place", shared), /robot 4: \(350, 250\) is .* outside the object/);
  await published(page);
  await reload(page);
  assert.deepEqual(await state(page), after);
  // Dragged back, it carries again; the others never changed their numbers.
  await drag(page, await toScreen(page, [350, 250]), await toScreen(page, [200, 100]));
  await idle(page);
  const back = await state(page);
  assert.equal(back.left_out, undefined);
  assert.equal(back.robots.length, 5);
  await undo(page);
  assert.deepEqual(await state(page), after);
  await page.done();
});

test("scripts place robots as arrays or text, and a place outside is refused", async () => {
  const page = await browser.open();
  await load(page, "(0,0)\n(4,0)\n(4,3)\n(0,3)\n");
  await set(page, {
    supports: [
      [0, 0],
      [4, 0],
      [2, 3],
    ],
  });
  await idle(page);
  const loads = (await state(page)).robots.map((robot) => robot.load);
  [25, 25, 50].forEach((load, i) => assert.ok(Math.abs(loads[i] - load) < 1e-9));
  await set(page, { supports: "0,0@30 4,0 2,3@40", snap: 0.01 });
  await idle(page);
  assert.deepEqual((await state(page)).capacity.overloaded, [2]);
  await set(page, { support_capacities: [30, null, 60] });
  await idle(page);
  assert.deepEqual((await state(page)).capacity.overloaded, []);
  const refused = await page.evaluate(() => {
    try {
      evenlift.set({ supports: [[9, 9]] });
    } catch (error) {
      return error.message;
    }
  });
  assert.match(refused, /outside the object/);
  await page.done();
});

test("the first button of the welcome card places robots to play with, also on a phone", async () => {
  for (const options of [{}, { viewport: phone, hasTouch: true, isMobile: true }]) {
    const page = await browser.open({ first: true, ...options });
    await idle(page);
    await page.locator("#welcome").getByRole("button", { name: "Place robots yourself" }).click();
    await idle(page);
    const placed = await state(page);
    assert.equal(placed.metric, "given");
    assert.equal(placed.robots.length, 4);
    await page.done();
  }
});

test("the tool Robot adds one where one clicks, and grabs those that stand there", async () => {
  const page = await browser.open();
  await load(page, asset("stone-slab"));
  const before = await state(page);
  await page.locator("#canvas").focus();
  await page.keyboard.press("Shift+D");
  const [x, y] = await toScreen(page, before.centre_of_mass);
  await page.mouse.click(x + 40, y + 25);
  await idle(page);
  const after = await state(page);
  assert.equal(after.metric, "given");
  assert.equal(after.robots.length, before.robots.length + 1);
  assert.equal(after.robots.at(-1).place, "beneath");
  await page.mouse.click(...(await toScreen(page, after.robots[1].at)));
  await idle(page);
  assert.equal((await state(page)).robots.length, after.robots.length, "a click on a robot adds none");
  await page.keyboard.press("Escape");
  await undo(page);
  assert.deepEqual(await state(page), before);
  await page.done();
});

test("the robots' places stand in a table beside the coordinates, and typing one moves its robot", async () => {
  const page = await browser.open();
  await load(page, asset("stone-slab"));
  const before = await state(page);
  await page.locator("#canvas").focus();
  await page.keyboard.press("e");
  const table = page.locator("#table");
  await table.getByRole("button", { name: "Robots", exact: true }).click();
  assert.equal(await table.locator("tbody tr").count(), before.robots.length);
  const typed = before.robots[2].at[0] + 0.25 * (before.centre_of_mass[0] - before.robots[2].at[0]);
  const toMiddle = before.centre_of_mass[1];
  await table.getByLabel("Robot 3, y", { exact: true }).fill(String(toMiddle));
  await table.getByLabel("Robot 3, y", { exact: true }).press("Tab");
  await table.getByLabel("Robot 3, x", { exact: true }).fill(String(typed));
  await table.getByLabel("Robot 3, x", { exact: true }).press("Tab");
  await idle(page);
  const after = await state(page);
  assert.equal(after.metric, "given");
  assert.deepEqual(after.supports[2], [typed, toMiddle]);
  // A place outside the object is refused, without a change.
  await table.getByLabel("Robot 3, x", { exact: true }).fill("1e6");
  await table.getByLabel("Robot 3, x", { exact: true }).press("Tab");
  await table.getByText(/is .* outside the object/).waitFor();
  assert.deepEqual((await state(page)).supports, after.supports);
  await table.getByRole("button", { name: "Add a robot" }).click();
  await idle(page);
  assert.equal((await state(page)).robots.length, before.robots.length + 1);
  await table.getByRole("button", { name: "Delete robot 1" }).click();
  await idle(page);
  assert.equal((await state(page)).robots.length, before.robots.length);
  await page.done();
});

test("the verdict offers what mends it: one press, one undo, and it gives what it says", async () => {
  const page = await browser.open();
  await load(page, asset("stone-slab"));
  for (const settings of [
    { metric: "distance", teams: 2 },
    { metric: "circle", teams: 1 },
    { metric: "random", teams: 2 },
  ]) {
    await set(page, { metric: "area", teams: 3 });
    await set(page, settings);
    await idle(page);
    const before = await state(page);
    const offer = page.locator("#mirror").getByRole("button", { name: /^(Use|Make it hold)/ });
    if ((await offer.count()) === 0) continue;
    const says = await offer.first().getAttribute("aria-label");
    await offer.first().click({ force: true });
    await idle(page);
    const after = await state(page);
    assert.ok(after.verdict.reasons.length < before.verdict.reasons.length, says);
    if (/held|Make it hold/.test(says)) assert.ok(after.closure.form_closure || after.closure.second_order, says);
    const covered = /(\d+) % covered/.exec(says);
    if (covered) assert.ok(after.coverage > before.coverage && after.coverage * 100 > Number(covered[1]) - 0.51, says);
    await undo(page);
    assert.deepEqual(await state(page), before);
  }
  await page.done();
});

test("a challenge shows the object alone, then both scores, and passes mine on without my robots", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await load(page, asset("grand-piano"));
  const answer = await state(page);
  const shared = await link(page);
  await page.done();
  const other = await browser.open({
    address: `?place=4&beat=29.3,8.1,0.61,0#${shared}`,
    permissions: ["clipboard-read", "clipboard-write"],
  });
  const card = other.locator("#challenge");
  await card.waitFor();
  const begun = await state(other);
  assert.deepEqual(begun.polygon, answer.polygon);
  assert.equal(begun.metric, "given");
  assert.equal(begun.robots.length, 4);
  const rows = () => card.locator("tbody tr").allInnerTexts();
  assert.match((await rows())[1], /To beat\s+4\s+29\.3 kg\s+8\.1 kg\s+61 %\s+no/);
  assert.equal((await rows()).length, 2);
  // No undo, offer or comparison tells where evenlift would put them.
  await undo(other);
  assert.deepEqual(await state(other), begun);
  for (const name of [/^Use /, "Show evenlift's"])
    assert.equal(await other.locator("#mirror").getByRole("button", { name }).count(), 0, String(name));
  const moved = await inwards(other, 0, -1.5);
  await published(other);
  assert.match(await other.evaluate(() => location.search), /^\?place=4&beat=/);
  await reload(other);
  assert.deepEqual((await state(other)).supports, moved.supports, "a reload keeps what was placed");
  await other.locator("#challenge").getByRole("button", { name: "Show evenlift's" }).click();
  await other.locator("#challenge").getByText("Can you beat this?").waitFor();
  assert.equal((await rows()).length, 3);
  await card.getByRole("button", { name: "Copy challenge with my score" }).click();
  await card.getByText(/^The challenge is copied/).waitFor();
  const copied = await other.evaluate(() => navigator.clipboard.readText());
  const [, most, spread] = /\?place=4&beat=([\d.]+),([\d.]+),/.exec(copied);
  assert.ok(Math.abs(most - moved.loads.max) < 0.01 && Math.abs(spread - moved.loads.spread) < 0.01);
  const passed = JSON.parse(evenlift("link", "decode", copied.split("#")[1]));
  assert.equal(passed.metric, "area");
  assert.deepEqual(passed.polygon, answer.polygon);
  // The same arrangement is a tie, although the link has rounded numbers.
  const tied = await browser.open({ address: `?${copied.split("?")[1]}` });
  await tied.locator("#challenge").waitFor();
  await set(tied, { supports: moved.supports.map((place) => place.join(",")).join(" ") });
  await idle(tied);
  assert.equal((await state(tied)).loads.max, moved.loads.max);
  assert.equal(await tied.locator("#challenge .best").count(), 0);
  await tied.done();
  await card.getByRole("button", { name: "Try again" }).click();
  await idle(other);
  assert.equal((await rows()).length, 2);
  assert.equal((await state(other)).robots.length, 4);
  await card.getByRole("button", { name: "Close" }).click();
  await published(other);
  assert.equal(await other.evaluate(() => location.search), "");
  await other.done();
  // Invalid numbers are not shown, and an address without a link asks about the sample.
  const odd = await browser.open({ address: "?place=4&beat=1,2,x,0" });
  await odd.locator("#challenge").waitFor();
  assert.equal(await odd.locator("#challenge tbody tr").count(), 1);
  assert.equal((await state(odd)).metric, "given");
  await odd.done();
});
