// `./dev soak` after the build: searches for broken promises with fresh seeds.
//
//   node tests/soak/soak.mjs [--compare] [MINUTES] [SEED]
//
// --compare runs only comparisons: the core against the oracle and itself, native against WebAssembly. They need only
// the build of `./dev test`; fuzzing needs all code once more, instrumented. Searches run side by side, one per
// processor, for MINUTES in all. Prints every failure with the command that repeats it, and finally a table. The exit
// status is 0 if nothing failed.
import { randomBytes } from "node:crypto";
import { existsSync } from "node:fs";
import { mkdir, rm } from "node:fs/promises";
import { cpus } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

import { compareStreams } from "./compare.mjs";
import { run } from "./run.mjs";
import { fuzzers, writeSeeds } from "./seeds.mjs";

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const bin = path.join(root, "build/bin");
const found = path.join(root, "build/soak/found");

const row = (kind, cases, passedOver, failures) => ({ kind, cases, passedOver, failures });

// A program that prints what is wrong, and at last how many it tried.
const searchBy = (kind, command) => async (seconds, seed) => {
  const words = command(seed, Math.ceil(seconds));
  const { lines, status, ending } = await run(words, {
    seconds: seconds + 300,
    onLine: (line) => line.startsWith("tried ") || console.log(line),
  });
  const totals = /^tried (\d+), passed over (\d+), failed (\d+)$/.exec(lines.at(-1) ?? "");
  if (!totals || (status !== 0 && totals[3] === "0")) {
    console.log(
      `${kind}: the program ended with ${ending}; to repeat it: ${words.map((word) => word.replace(`${root}/`, "")).join(" ")}`,
    );
    return row(kind, 0, 0, 1);
  }
  return row(kind, Number(totals[1]), Number(totals[2]), Number(totals[3]));
};

// The C++ program's searches: the oracle; one shape, one answer; answers within their bounds of time.
const searchOf = (kind) =>
  searchBy(kind, (seed, seconds) => [path.join(bin, "evenlift_soak"), kind, `${seed}`, `${seconds}`]);

// Robots that are off by less than promised.
const searchAccuracy = searchBy("accuracy", (seed, seconds) => [
  "python3",
  path.join(root, "tests/accuracy/check_accuracy.py"),
  path.join(bin, "evenlift"),
  path.join(root, "assets/polygons"),
  "--seed",
  `${seed}`,
  "--seconds",
  `${seconds}`,
]);

const placements = "native = WebAssembly";
async function searchPlacements(seconds, seed) {
  const native = [path.join(bin, "evenlift_fingerprint")];
  const webAssembly = [process.execPath, path.join(bin, "evenlift_fingerprint.js")];
  const { cases, different } = await compareStreams({ native, webAssembly, first: seed, seconds });
  for (const { number, problem } of different) {
    console.log(`${placements}: document ${number}: ${problem}; to repeat it:`);
    console.log(`  build/bin/evenlift_fingerprint show ${number} >build/soak/native.txt; \\`);
    console.log(`  node build/bin/evenlift_fingerprint.js show ${number} | diff build/soak/native.txt -`);
  }
  return row(placements, cases, 0, different.length);
}

// libFuzzer ends at its first finding, and leaves the input in a file.
const fuzz = (name) => async (seconds, seed) => {
  const kind = `fuzzing: ${fuzzers[name].what}`;
  const corpus = path.join(root, "build/soak/corpus", name);
  await mkdir(corpus, { recursive: true });
  const seeds = await writeSeeds(root, name);
  const program = `build/fuzz/tests/fuzz_${name}`;
  const { lines, status, ending } = await run(
    [
      path.join(root, program),
      `-max_total_time=${Math.max(1, Math.round(seconds))}`,
      `-seed=${(seed % 0xffffffff) + 1}`,
      `-max_len=${fuzzers[name].longest}`,
      `-artifact_prefix=${found}/${name}-`,
      "-timeout=120", // far more than such an input takes, even on a busy machine
      "-rss_limit_mb=2048",
      "-print_final_stats=1",
      corpus,
      seeds,
    ],
    { seconds: seconds + 300 },
  );
  const executed = lines.map((line) => /^stat::number_of_executed_units:\s+(\d+)/.exec(line)).find(Boolean);
  if (status === 0 && executed) return row(kind, Number(executed[1]), 0, 0);
  const written = lines.map((line) => /Test unit written to (.*)$/.exec(line)).find(Boolean);
  console.log(lines.slice(-60).join("\n"));
  const input = written ? path.relative(root, written[1]) : `-seed=${(seed % 0xffffffff) + 1}`;
  console.log(`${kind}: the fuzzer ended with ${ending}; to repeat it: ${program} ${input}`);
  return row(kind, Number(executed?.[1] ?? 0), 0, 1);
};

// With their parts of the time.
const comparisons = [
  { part: 4, search: searchOf("oracle") },
  { part: 4, search: searchOf("one-shape") },
  { part: 4, search: searchOf("files") },
  { part: 4, search: searchPlacements },
];
// Their time is measured, so they are not among those that a busy machine runs.
const bounds = { part: 4, search: searchOf("bounds") };
const accuracy = { part: 4, search: searchAccuracy };
const fuzzing = Object.keys(fuzzers).map((name) => ({ part: 1, search: fuzz(name) }));

// `together` at a time, in about this many seconds. Returns the table's rows in order.
async function runAll(searches, seconds, seed, together) {
  const parts = searches.reduce((sum, { part }) => sum + part, 0);
  const rows = [];
  let next = 0;
  async function runSome() {
    while (next < searches.length) {
      const at = next++;
      const { part, search } = searches[at];
      const began = performance.now();
      const result = await search(Math.min(seconds, (seconds * together * part) / parts), seed);
      rows[at] = { ...result, seed, seconds: (performance.now() - began) / 1000 };
    }
  }
  await Promise.all(Array.from({ length: together }, runSome));
  return rows;
}

function numberFrom(text, what, least, most) {
  const value = Number(text);
  if (/^\d+(\.\d+)?$/.test(text) && value >= least && value <= most) return value;
  console.error(`evenlift: soak: ${what} must be a number from ${least} to ${most}, not "${text}"`);
  process.exit(2);
}

function table(rows) {
  const lines = [["kind", "cases", "passed over", "seconds", "seed", "failures"]];
  for (const r of rows)
    lines.push([r.kind, r.cases, r.passedOver, r.seconds.toFixed(0), r.seed, r.failures].map(String));
  const width = lines[0].map((_, column) => Math.max(...lines.map((line) => line[column].length)));
  const text = (line) =>
    `| ${line.map((cell, i) => (i === 0 ? cell.padEnd(width[i]) : cell.padStart(width[i]))).join(" | ")} |`;
  const rule = `| ${width.map((w, i) => (i === 0 ? "-".repeat(w) : `${"-".repeat(w - 1)}:`)).join(" | ")} |`;
  return [text(lines[0]), rule, ...lines.slice(1).map(text)].join("\n");
}

async function main([...argv]) {
  const onlyCompares = argv[0] === "--compare";
  if (onlyCompares) argv.shift();
  const minutes = numberFrom(argv[0] ?? "10", "the minutes", 0.1, 10000);
  // Far below 2^53, to count up from it exactly.
  const seed = argv[1] === undefined ? randomBytes(6).readUIntBE(0, 6) : numberFrom(argv[1], "the seed", 0, 2 ** 48);
  console.log(`evenlift: soaking for ${minutes} minutes, seed ${seed}`);
  await rm(found, { recursive: true, force: true });
  await mkdir(found, { recursive: true });
  const searches = onlyCompares ? comparisons : [...comparisons, bounds, accuracy, ...fuzzing];
  const rows = await runAll(searches, minutes * 60, seed, Math.max(1, cpus().length));
  console.log(table(rows));
  // A search that tried nothing proves nothing.
  const failures = rows.reduce((sum, { failures }) => sum + failures, 0);
  const idle = rows.filter(({ cases }) => cases === 0).map(({ kind }) => kind);
  if (idle.length > 0) console.log(`evenlift: nothing was tried: ${idle.join(", ")}`);
  console.log(failures === 0 && idle.length === 0 ? "evenlift: all is well" : `evenlift: ${failures} failures`);
  if (failures === 0 && existsSync(found)) await rm(found, { recursive: true });
  return failures === 0 && idle.length === 0 ? 0 : 1;
}

process.exitCode = await main(process.argv.slice(2));
