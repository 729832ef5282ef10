// The page's files as a server sends them, after gzip -9.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { pageFolder } from "./browser.mjs";

const bytesOf = (name) => gzipSync(readFileSync(path.join(pageFolder, name)), { level: 9 }).length;

// All files, by name.
export const sizes = () => readdirSync(pageFolder).map((name) => ({ name, bytes: bytesOf(name) }));

// The files that a page has asked for when its first picture is there. What it loads afterwards, such as the controls in
// HTML, may be there before this question is.
export async function loaded(page) {
  const addresses = await page.evaluate(() => {
    const [{ startTime: ready }] = performance.getEntriesByName("ready", "mark");
    const before = performance.getEntriesByType("resource").filter(({ startTime }) => startTime < ready);
    return before.map(({ name }) => name);
  });
  const names = new Set(["index.html", ...addresses.map((address) => new URL(address).pathname.slice(1))]);
  return [...names].map((name) => ({ name, bytes: bytesOf(name) }));
}

export const total = (files) => files.reduce((sum, { bytes }) => sum + bytes, 0);
