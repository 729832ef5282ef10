import { readFileSync } from "node:fs";
import { startBrowser, idle, phone, wide } from "./browser.mjs";
import { drop } from "./windows.mjs";
const b = await startBrowser([], { drawn: true });
const file = process.argv[2] ?? "/work/main/examples/sheet/sheet.dxf";
for (const [name, view] of [
  ["wide", wide],
  ["phone", phone],
]) {
  const page = await b.open({ viewport: view });
  const t0 = Date.now();
  await drop(page, { files: [["sheet.dxf", readFileSync(file, "utf8")]] });
  await page.locator("#shapes .sample").first().waitFor();
  await idle(page);
  await page.screenshot({ path: `/tmp/s-${name}-0.png` });
  await page.getByRole("button", { name: "All in a table" }).click();
  await page.locator("#parts").waitFor();
  await page.waitForTimeout(300);
  await page.screenshot({ path: `/tmp/s-${name}-1.png` });
  await idle(page);
  console.log(Date.now() - t0);
  await page.locator("#parts input").nth(0).fill("0,25");
  await page.locator("#parts input").nth(1).fill("8");
  await page.locator("#parts input").nth(2).fill("7850/m3");
  await page.getByRole("button", { name: "Place robots" }).click();
  await idle(page);
  await page.getByRole("button", { name: "Weight", exact: true }).click();
  await page.screenshot({ path: `/tmp/s-${name}-2.png` });
  console.log(await page.locator("#parts .asked").textContent());
  await page.locator("#parts tbody button").first().click();
  await idle(page);
  await page.screenshot({ path: `/tmp/s-${name}-3.png` });
  await page.close?.();
}
await b.close();
process.exit(0);
