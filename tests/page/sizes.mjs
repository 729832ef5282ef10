// What the page weighs, as a server sends it.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { pageFolder } from "./browser.mjs";

// What comes before the first picture, and is all that drawing, placing and the lesson need. The rest comes when it is
// asked for: windows and their lists, experiments.
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
