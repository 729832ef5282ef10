// node compare.mjs NATIVE.json WEBASSEMBLY.json: a table of two outputs of Google Benchmark, with their ratio. The
// fastest of repeated runs counts: other work only slows a run down.
import { readFileSync } from "node:fs";

const toMilliseconds = { ns: 1e-6, us: 1e-3, ms: 1, s: 1e3 };

function fastestRuns(path) {
  const fastest = new Map();
  for (const run of JSON.parse(readFileSync(path, "utf8")).benchmarks) {
    if (run.run_type !== "iteration") continue;
    const time = run.real_time * toMilliseconds[run.time_unit];
    fastest.set(run.run_name, Math.min(time, fastest.get(run.run_name) ?? Infinity));
  }
  return fastest;
}

const [native, webAssembly] = process.argv.slice(2).map(fastestRuns);
const line = (name, ...numbers) => console.log(name.padEnd(44), ...numbers.map((text) => text.padStart(14)));
line("", "native ms", "WebAssembly ms", "ratio");
for (const [name, time] of webAssembly) {
  if (!native.has(name)) continue;
  line(name, native.get(name).toFixed(3), time.toFixed(3), (time / native.get(name)).toFixed(2));
}
