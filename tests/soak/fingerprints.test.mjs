// Native and WebAssembly agree on 2,000 documents of every family, with every method and setting.
import assert from "node:assert/strict";
import path from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

import { compareBatches } from "./compare.mjs";

const bin = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../../build/bin");

test("native and WebAssembly place 2,000 documents alike", async () => {
  const native = [path.join(bin, "evenlift_fingerprint")];
  const webAssembly = [process.execPath, path.join(bin, "evenlift_fingerprint.js")];
  const { cases, different } = await compareBatches({ native, webAssembly, first: 0, count: 2000 });
  assert.deepEqual(different, []);
  assert.equal(cases, 2000);
});
