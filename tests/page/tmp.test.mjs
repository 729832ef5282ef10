import { test } from "node:test";
import { sharedBrowser, load, asset, idle } from "./browser.mjs";
import { drop, openWindow } from "./windows.mjs";
import { readFile } from "node:fs/promises";
const browser = sharedBrowser({ drawn: true });
test("shot", async () => {
  const page = await browser.open({ drawn: true });
  await load(page, asset("cross"));
  await drop(page, { files: [["levels.svg", await readFile("/tmp/levels.svg", "utf8")]] });
  await page.locator("#shapes .sample").first().waitFor();
  await idle(page);
  await page.screenshot({ path: "/tmp/levels.png" });
});
