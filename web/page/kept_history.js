// The browser keeps the newest steps, so that undo survives a reload. Each is a line `EDIT METHOD LINK`
// (wasm/page/page_api.cpp) after `<` if undo leads to it and `>` if redo does, the nearest first. A line `=` before
// them has the compared method and the document's link. They are kept beside their work (publisher.js). Loaded after
// the first frame.
import { historyKey, lasting, ofThisTab, read, workKey, write } from "./storage.js";

const mostSteps = 500;
const mostBytes = 400000; // of some 5 MB that browsers give; the work itself needs up to 4
const leastBytes = 1000;

// As many as fit.
function lines(program, most) {
  const all = [];
  let left = most;
  for (const redo of [0, 1]) {
    for (let i = 0; all.length < mostSteps; ++i) {
      const step = program.json("page_kept_step", redo, i);
      if (!step) break;
      const line = `${"<>"[redo]} ${step.edit} ${step.method} ${step.link}`;
      left -= line.length + 1;
      // A polygon too large for a link ends the steps.
      if (left < 0 || (!step.link && most < Infinity)) break;
      all.push(line);
    }
  }
  return all;
}

const parts = (line) => line.split(" ");

function restore(program, text) {
  const own = lines(program, Infinity).map(parts);
  // Not all steps could be written and read.
  if (own.length === mostSteps || own.some(([, , , link]) => !link)) return;
  const kept = text
    .split("\n")
    .map(parts)
    .filter((line) => line.length === 4);
  const [past, future] = ["<", ">"].map((mark) => kept.filter(([first]) => first === mark));
  // A refused polygon is opened as an edit of the last good one, which may already be a step.
  if (own.length && own.at(-1)[3] === past[0]?.[3]) past.shift();
  program.call("page_forget_steps");
  for (const [mark, edit, method, link] of [
    ...past.reverse(),
    ...own.reverse(),
    ...(own.length ? [] : future.reverse()),
  ]) {
    program.call("page_add_step", mark === ">" ? 1 : 0, Number(edit), Number(method), link);
  }
}

function comparison(program, most) {
  const method = program.number("page_compared");
  const line = method ? `= ${method} ${program.text("page_link")}` : "";
  return line && line.length < most ? [line] : [];
}

// If the same document is open.
function restoreComparison(program, text) {
  const [mark, method, link] = parts(text.split("\n", 1)[0]);
  if (mark === "=" && link && link === program.text("page_link")) program.call("page_compare", Number(method));
}

function asText(program, most) {
  const compared = comparison(program, most);
  return [...compared, ...lines(program, most - compared.join().length)].join("\n");
}

function keep(storage, program, whole) {
  for (let most = mostBytes; most > leastBytes; most /= 4) {
    const text = most === mostBytes ? whole : asText(program, most);
    if (read(storage, historyKey) === text || write(storage, historyKey, text)) return;
  }
  write(storage, historyKey, "");
}

// The kept steps come before those of this visit, and all are kept from now on.
export function keepHistory(program) {
  const before = read(ofThisTab, historyKey);
  // If these steps stop the page, the next start must not find them.
  const sources = [ofThisTab, lasting].filter((storage) => read(storage, historyKey) === before);
  for (const storage of sources) write(storage, historyKey, "");
  if (before) restore(program, before);
  restoreComparison(program, before);
  for (const storage of sources) if (!read(storage, historyKey)) write(storage, historyKey, before);

  const keepAll = () => {
    if (program.stopped) return;
    const whole = asText(program, mostBytes);
    keep(ofThisTab, program, whole);
    // The next visit continues the work of the tab with the latest change.
    if (read(lasting, workKey) === read(ofThisTab, workKey)) keep(lasting, program, whole);
  };
  document.addEventListener("evenlift-kept", keepAll);
  keepAll();
}
