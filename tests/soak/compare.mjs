// Checks that the native and the WebAssembly program print the same fingerprints. Calls cover many documents; if two
// lines differ, the batch is repeated one document at a time.
import { run } from "./run.mjs";

const batch = 1000;
const mostBatchesAtATime = 10;
// If a batch hangs: a hundred times its usual duration.
const secondsForABatch = 120;
const mostDifferences = 20;

const ask = (program, first, count, ...more) =>
  run([...program, `${first}`, `${count}`, ...more], { seconds: secondsForABatch * Math.ceil(count / batch) });

// The first document on which the two disagree; `ended` says how they ended on the whole batch.
async function findDocument({ native, webAssembly, first, count, ended }) {
  const [a, b] = await Promise.all([ask(native, first, count, "each"), ask(webAssembly, first, count, "each")]);
  for (let i = 0; i < count; ++i) {
    if (a.lines[i] !== undefined && a.lines[i] === b.lines[i]) continue;
    const number = first + i;
    if (a.lines[i] === undefined && a.status !== 0)
      return { number, problem: `the native program ended with ${a.ending}` };
    if (b.lines[i] === undefined && b.status !== 0)
      return { number, problem: `the WebAssembly program ended with ${b.ending}` };
    return { number, problem: "native and WebAssembly differ" };
  }
  return { number: first, problem: `a batch of ${count} differs, but none of its documents by itself (${ended})` };
}

// Compares `count` documents from `first` on. Returns the number that agree, and the differences.
export async function compareBatches({ native, webAssembly, first, count, most = mostDifferences }) {
  const [a, b] = await Promise.all([ask(native, first, count), ask(webAssembly, first, count)]);
  const ended = `native: ${a.ending}, WebAssembly: ${b.ending}`;
  const different = [];
  let cases = 0;
  for (let i = 0; i * batch < count && different.length < most; ++i) {
    const here = Math.min(batch, count - i * batch);
    if (a.lines[i] !== undefined && a.lines[i] === b.lines[i]) cases += here;
    else different.push(await findDocument({ native, webAssembly, first: first + i * batch, count: here, ended }));
  }
  return { cases, different };
}

// Compares until the time is over: one batch, then as many as fit into the rest.
export async function compareStreams({ native, webAssembly, first, seconds, chunk = batch }) {
  const began = performance.now();
  const left = () => seconds * 1000 - (performance.now() - began);
  const different = [];
  let cases = 0;
  for (let from = first, size = chunk; left() > 0 && different.length < mostDifferences;) {
    const asked = performance.now();
    const most = mostDifferences - different.length;
    const found = await compareBatches({ native, webAssembly, first: from, count: size, most });
    cases += found.cases;
    different.push(...found.different);
    from += size;
    const batchesThatFit = Math.floor((left() / (performance.now() - asked)) * (size / batch));
    size = batch * Math.max(1, Math.min(mostBatchesAtATime, batchesThatFit));
  }
  return { cases, different };
}
