// What receivers of a link see: a title, one line of introduction, and other sites' previews.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { controlIfShown, idle, jsQR, link, pageFolder, set, sharedBrowser } from "../page/browser.mjs";
import { closeAll, noticed, openWindow } from "../page/windows.mjs";

const browser = sharedBrowser();
const plainly = (text) => text.replaceAll("\u00a0", " ");

test("the title of the tab is the result", async () => {
  const page = await browser.open();
  await idle(page);
  assert.match(plainly(await page.title()), /^6 robots carry .* – evenlift$/);
  await set(page, { teams: 2 });
  await page.waitForFunction(() => document.title.startsWith("4 robots carry"));
  await page.done();
});

test("a link opens with one line of introduction, which goes at the first touch", async () => {
  const address = `#${await anyLink()}`;
  const page = await browser.open({ address, first: true });
  assert.match(await noticed(page), /^You see an object from above, and the robots that lift it\./);
  assert.ok(await controlIfShown(page, "close"));
  await page.mouse.click(20, 400);
  await idle(page);
  assert.equal(await controlIfShown(page, "close"), null, "gone at the first touch");
  await page.done();
  // A visitor who knows the page, and an address without a link, are spared it.
  for (const options of [{ address }, { first: true }]) {
    const other = await browser.open(options);
    assert.doesNotMatch(await noticed(other), /from above/);
    await other.done();
  }
});

async function anyLink() {
  const page = await browser.open();
  const shared = await link(page);
  await page.done();
  return shared;
}

test("Share has the code to embed the figure, which works", async () => {
  const page = await browser.open({ permissions: ["clipboard-read", "clipboard-write"] });
  const window = await openWindow(page, "save");
  await window.getByRole("button", { name: "Copy code to embed" }).click();
  await window.getByText("The code is copied").waitFor();
  const code = await page.evaluate(() => navigator.clipboard.readText());
  const address = /^<iframe src="([^"]+)" title="evenlift" .*><\/iframe>$/.exec(code)[1].replaceAll("&amp;", "&");
  assert.match(address, /\?embed=1#\d\./);
  await closeAll(page);
  const figure = await browser.open({ address: address.slice(address.indexOf("?")) });
  assert.equal(await link(figure), await link(page));
  await figure.done();
  await page.done();
});

test("other sites show a title, a sentence and a picture of the page", () => {
  const html = readFileSync(path.join(pageFolder, "index.html"), "utf8");
  const property = (name) => new RegExp(`<meta property="og:${name}" content="([^"]+)">`).exec(html)[1];
  assert.ok(property("title") && property("description") && property("image:alt"));
  assert.ok(existsSync(path.join(pageFolder, property("image"))));
});

test("a handout ends in the address of its lesson, and in a code that leads there", async () => {
  const page = await browser.open({ address: "?lesson=task-thirty&number=5" });
  await page.locator("#task").waitFor();
  await openWindow(page, "lessons");
  await page.getByRole("button", { name: "Handout …" }).click();
  const way = page.locator("#handout .paper-way");
  await way.waitFor();
  const printed = await way.innerText();
  assert.match(printed, /\?lesson=task-thirty&number=5#\d\./);
  assert.match(plainly(await page.locator("#handout .pages").innerText()), /The greatest load is at most 30 kg/);
  const code = await way.locator("img").evaluate(async (image) => {
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: 600, height: 600 });
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0, 600, 600);
    return [...context.getImageData(0, 0, 600, 600).data];
  });
  assert.equal(jsQR(new Uint8ClampedArray(code), 600, 600).data, printed.trim());
  await closeAll(page);
  await page.done();
});
