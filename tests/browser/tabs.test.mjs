// Each tab keeps its own work, address and undo, through reloads and crashes.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import {
  asset,
  evenlift,
  fragment,
  idle,
  link,
  load,
  press,
  reload,
  sample,
  set,
  sharedBrowser,
  state,
  undo,
  wide,
} from "../page/browser.mjs";

const browser = sharedBrowser();

const encoded = (name, ...options) => evenlift("link", "encode", sample(name), ...options).trim();
const teams = async (page) => (await state(page)).requested_teams;

// A tab opened by another, as a popup or after a crash, has only these scripts of ours.
let context;
after(() => context?.close());
async function fresh() {
  await context?.close();
  context = await browser.browser.newContext({ viewport: wide, colorScheme: "light" });
  await context.addInitScript(() => {
    if (globalThis.ServiceWorkerContainer)
      ServiceWorkerContainer.prototype.register = () => Promise.reject(new Error("not here"));
  });
}
// The kept steps are there when nothing is under way.
async function tab(address = "") {
  const page = await browser.open({ context, address });
  await idle(page);
  return page;
}

async function focused(page) {
  await page.bringToFront();
  await page.locator("#canvas").focus();
}

// Reloads a tab: it shows the same, its address names that, and undos lead to these links.
async function comesBack(page, links, why) {
  const mine = await link(page);
  await idle(page);
  await reload(page);
  assert.equal(await link(page), mine, `${why}: its work`);
  assert.equal(await fragment(page), mine, `${why}: its address`);
  await focused(page);
  for (const [i, expected] of links.entries()) {
    await undo(page);
    assert.equal(await link(page), expected, `${why}: undo ${i + 1}`);
  }
}

test("two tabs on the same address: each keeps what it shows, and its own undo", async () => {
  await fresh();
  const a = await tab();
  const first = await link(a);
  await press(a, "teams -");
  await idle(a);
  const two = await link(a);
  const b = await tab(`#${await fragment(a)}`);
  assert.equal(await teams(b), 2);
  const links = [two];
  for (const expected of [3, 4]) {
    await press(b, "teams +");
    await idle(b);
    assert.equal(await teams(b), expected);
    links.unshift(await link(b));
  }
  await press(a, "teams -");
  await idle(a);
  assert.equal(await teams(a), 1);
  // The address with which both began is one step; no step leads from it to itself.
  await comesBack(b, [...links.slice(1), first], "the second tab");
  await comesBack(a, [two, first], "the first tab");
  await a.done();
  await b.done();
});

test("a tab that began as a shared link and was edited keeps its own, and so does one that was not", async () => {
  await fresh();
  const a = await tab();
  await load(a, asset("violin"));
  await idle(a);
  const violin = await link(a);
  const edited = await tab(`#${encoded("guitar", "--teams", "4")}`);
  await set(edited, { teams: 2 });
  await idle(edited);
  const two = await link(edited);
  const untouched = await tab(`#${encoded("star")}`);
  await idle(untouched);
  await set(a, { weight: 437 });
  await load(a, asset("anchor"));
  await idle(a);
  await comesBack(edited, [encoded("guitar", "--teams", "4"), violin], "the edited tab");
  await comesBack(untouched, [two], "the untouched tab");
  for (const page of [a, edited, untouched]) await page.done();
});

test("a visit without a link opens what was changed last, in whichever tab; that a link was only looked at counts for nothing", async () => {
  await fresh();
  const a = await tab();
  const b = await tab();
  await load(a, asset("violin"));
  await idle(a);
  const one = await link(a);
  await load(b, asset("guitar"));
  await set(b, { teams: 2 });
  await idle(b);
  const other = await link(b);
  const looking = await tab(`#${encoded("star")}`);
  await idle(looking);
  await reload(looking);
  await reload(a);
  let c = await tab();
  assert.equal(await link(c), other);
  await focused(c);
  await undo(c);
  assert.equal(await link(c), encoded("guitar"), "with its undo");
  await c.done();
  await set(a, { teams: 1 });
  await idle(a);
  c = await tab();
  await focused(c);
  await undo(c);
  assert.equal(await link(c), one, "what the other tab has changed since");
  for (const page of [c, a, b, looking]) await page.done();
});

test("in a tab that has work of its own an address without a link opens that", async () => {
  await fresh();
  const a = await tab();
  await load(a, asset("violin"));
  await idle(a);
  const mine = await link(a);
  const b = await tab();
  await load(b, asset("guitar"));
  await idle(b);
  await a.goto("about:blank");
  await a.goto(browser.server.url);
  await a.evaluate(() => evenlift.ready);
  assert.equal(await link(a), mine);
  await a.done();
  await b.done();
});

test("a duplicated tab has the same work and undo, and is a tab of its own from then on", async () => {
  await fresh();
  const a = await tab();
  await load(a, asset("violin"));
  await set(a, { teams: 2 });
  await idle(a);
  const violin = encoded("violin"),
    two = await link(a);
  const coming = a.waitForEvent("popup");
  await a.evaluate(() => void open(location.href)); // with this tab's storage, as a browser duplicates it
  const copy = await coming;
  await copy.waitForFunction(() => globalThis.evenlift);
  await copy.evaluate(() => evenlift.ready);
  assert.equal(await link(copy), two);
  await set(copy, { metric: "circle" });
  await idle(copy);
  await set(a, { weight: 437 });
  await idle(a);
  await comesBack(copy, [two, violin], "the copy");
  await comesBack(a, [two, violin], "the tab that it was made of");
  await copy.close();
  await a.done();
});

test("a shape that is being drawn stays in its tab", async () => {
  await fresh();
  const a = await tab();
  await focused(a);
  await a.keyboard.press("d");
  for (const at of [
    [300, 300],
    [500, 300],
  ])
    await a.mouse.click(...at);
  await idle(a);
  const b = await tab(`#${encoded("guitar")}`);
  await set(b, { teams: 2 });
  await idle(b);
  await reload(a);
  await focused(a);
  await a.mouse.click(400, 500);
  await a.keyboard.press("Enter");
  await idle(a);
  assert.equal((await state(a)).polygon.length, 3, "the two vertices were still there");
  await reload(b);
  await focused(b);
  await b.keyboard.press("Enter");
  assert.equal(await teams(b), 2);
  await a.done();
  await b.done();
});

test("after a crash a tab comes back with its own work and undo", async () => {
  await fresh();
  const a = await tab();
  const b = await browser.open({ context, quiet: false });
  await load(b, asset("guitar"));
  await set(b, { teams: 2 });
  await idle(b);
  const mine = await link(b);
  await load(a, asset("violin"));
  await idle(a);
  const client = await context.newCDPSession(b);
  await client.send("Page.enable");
  const crashed = b.waitForEvent("crash");
  client.send("Page.crash").catch(() => {});
  await crashed;
  const loaded = new Promise((done) => client.once("Page.loadEventFired", done));
  await client.send("Page.reload");
  await loaded;
  const ask = async (expression) =>
    (await client.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true })).result.value;
  assert.equal(await ask("evenlift.ready.then(() => evenlift.link())"), mine);
  const key = { key: "z", code: "KeyZ", ctrlKey: true, bubbles: true };
  assert.equal(
    await ask(`evenlift.idle().then(() => {
    document.getElementById("canvas").dispatchEvent(new KeyboardEvent("keydown", ${JSON.stringify(key)}));
    return evenlift.link();
  })`),
    encoded("guitar"),
  );
  await b.close();
  await a.done();
});
