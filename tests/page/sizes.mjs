// The sizes of the page's files, as a server sends them.
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { pageFolder } from "./browser.mjs";

// The files loaded before the first frame: enough for drawing, placing and the lesson. The rest is loaded on demand:
// windows and their lists, experiments.
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
