// The page's files as a server sends them, after gzip -9.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { pageFolder } from "./browser.mjs";

const bytesOf = (name) => gzipSync(readFileSync(path.join(pageFolder, name)), { level: 9 }).length;

// All files, by name.
export const sizes = () => readdirSync(pageFolder).map((name) => ({ name, bytes: bytesOf(name) }));

// The files that a page has loaded when it becomes ready. What comes later, as the controls in HTML do, may be there
// before the question is.
export async function loaded(page) {
  const addresses = await page.evaluate(() => {
    const [{ startTime: ready }] = performance.getEntriesByName("ready", "mark");
    const before = performance.getEntriesByType("resource").filter(({ responseEnd }) => responseEnd <= ready);
    return before.map(({ name }) => name);
  });
  const names = new Set(["index.html", ...addresses.map((address) => new URL(address).pathname.slice(1))]);
  return [...names].map((name) => ({ name, bytes: bytesOf(name) }));
}

export const total = (files) => files.reduce((sum, { bytes }) => sum + bytes, 0);
