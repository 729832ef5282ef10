// The page's files as a server sends them.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { pageFolder } from "./browser.mjs";

// Loaded before the first picture. The rest of the program follows it; windows, their lists and experiments are loaded
// on demand.
const atStart = ["index.html", "icon.svg", "page.css", "page.js", "evenlift.js", "evenlift.wasm"];

export function sizes() {
  const files = readdirSync(pageFolder).map((name) => ({
    name,
    bytes: gzipSync(readFileSync(path.join(pageFolder, name)), { level: 9 }).length,
    atStart: atStart.includes(name),
  }));
  const total = (some) => some.reduce((sum, { bytes }) => sum + bytes, 0);
  return { files, start: total(files.filter((file) => file.atStart)), all: total(files) };
}
