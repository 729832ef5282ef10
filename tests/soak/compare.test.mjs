// The comparison itself, with programs that differ on purpose.
import assert from "node:assert/strict";
import test from "node:test";

import { compareStreams } from "./compare.mjs";

// Replaces evenlift_fingerprint: prints a line for each batch or document; `wrong` is its behaviour at one document.
const standIn = `
const { writeSync } = require("fs"); // unlike console.log, before a crash
const [wrong, at, first, count, each] = process.argv.slice(1);
const step = each ? 1 : 1000;
for (let i = 0; i < Number(count); i += step) {
  const number = Number(first) + i;
  const here = Number(at) >= number && Number(at) < number + step;
  if (here && wrong === "crash") process.kill(process.pid, "SIGSEGV");
  if (here && wrong === "stop") process.exit(0);
  writeSync(1, number + (here && wrong === "differ" ? " another" : " a hash") + "\\n");
}`;
const program = (wrong, at) => [process.execPath, "-e", standIn, "--", wrong, `${at}`];
const good = program("nothing", 0);

const compare = (native, webAssembly) =>
  compareStreams({ native, webAssembly, first: 7000, seconds: 0.001, chunk: 3000 });

test("programs that agree have no differences", async () => {
  assert.deepEqual(await compare(good, good), { cases: 3000, different: [] });
});

test("a difference is traced to its document, and the other batches count", async () => {
  const { cases, different } = await compare(good, program("differ", 8123));
  assert.equal(cases, 2000);
  assert.deepEqual(different, [{ number: 8123, problem: "native and WebAssembly differ" }]);
});

test("a program that crashes is traced to the document at which it does", async () => {
  const { different } = await compare(program("crash", 9999), good);
  assert.equal(different.length, 1);
  assert.equal(different[0].number, 9999);
  assert.match(different[0].problem, /^the native program ended with signal SIGSEGV$/);
});

test("a program that stops early without an error is a difference, too", async () => {
  const { cases, different } = await compare(good, program("stop", 7000));
  assert.equal(cases, 0);
  assert.equal(different[0].number, 7000);
});
