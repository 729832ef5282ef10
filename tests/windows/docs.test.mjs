import assert from "node:assert/strict";
import { test } from "node:test";
import { phone, sharedBrowser } from "../page/browser.mjs";
import { openWindow, violations } from "../page/windows.mjs";

const browser = sharedBrowser();

// From the About window.
async function documents() {
  const page = await browser.open();
  const about = await openWindow(page, "about");
  const all = await about.locator("ul a").evaluateAll((links) => links.map((link) => link.getAttribute("href")));
  await page.done();
  return all.map((address) => new URL(address).pathname.slice(1));
}

test("About leads to documents whose links and pictures all are there", async () => {
  const all = await documents();
  assert.ok(all.length >= 6, String(all));
  const anchors = new Map(),
    links = [];
  for (const address of all) {
    const page = await browser.open({ address, ready: false });
    assert.equal(await page.locator("h1").count(), 1, address);
    assert.ok((await page.locator("h2").count()) >= 3, `${address} has headings`);
    anchors.set(address, await page.locator("[id]").evaluateAll((ids) => ids.map(({ id }) => id)));
    for (const href of await page.locator("a").evaluateAll((found) => found.map((a) => a.href)))
      links.push([address, new URL(href)]);
    const pictures = await page.locator("img").evaluateAll((found) =>
      Promise.all(
        found.map((image) =>
          image.decode().then(
            () => image.alt.length > 0,
            () => image.src,
          ),
        ),
      ),
    );
    assert.ok(
      pictures.every((good) => good === true),
      `${address}: ${pictures}`,
    );
    // Unconverted Markdown looks like this.
    const words = await page.locator("main").evaluate((main) => {
      const copy = main.cloneNode(true);
      for (const code of copy.querySelectorAll("pre, code")) code.remove();
      return copy.textContent;
    });
    assert.doesNotMatch(words, /\]\(|\*\*|`|^#{1,6} |^\|/m, address);
    await page.done();
  }
  assert.ok(links.length > 40);
  for (const [from, to] of links) {
    const name = to.pathname.slice(1);
    assert.ok(anchors.has(name), `${from} leads to ${to}`);
    if (to.hash) assert.ok(anchors.get(name).includes(decodeURIComponent(to.hash.slice(1))), `${from} leads to ${to}`);
  }
});

test("a document can be read on a phone and in the dark, without a script", async () => {
  for (const options of [{}, { viewport: phone, hasTouch: true, isMobile: true, colorScheme: "dark" }]) {
    const page = await browser.open({ address: "docs-algorithm.html", ready: false, ...options });
    assert.equal(await page.evaluate(() => document.scripts.length), 0);
    assert.ok(
      await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
      "nothing is wider than the window",
    );
    assert.deepEqual(await violations(page), []);
    await page.done();
  }
});
