// Undo survives a reload: the newest steps are kept in the browser, as a line for each (wasm/page/page_api.cpp), `<` before
// those to be undone, `>` before those to be redone, the nearest first; and before them `=`, the method that the document is
// compared with, and its link. Loaded after the first picture.
import { lasting, read, write } from "./storage.js";
import { underWay } from "./under_way.js";

const key = "evenlift.history";  // publisher.js removes it where it keeps no work
const mostSteps = 500;
const mostBytes = 400000;  // of some 5 MB that browsers give; the work itself needs up to 4
const pause = 400;

// The steps as lines, as many as fit.
function lines(program, most) {
  const all = [];
  let left = most;
  for (const redo of [0, 1]) {
    for (let i = 0; all.length < mostSteps; ++i) {
      const step = program.text("page_kept_step", redo, i);
      left -= step.length + 3;
      // Beyond a polygon that is too large for a link nothing is kept.
      if (!step || left < 0 || (step.endsWith(" ") && most < Infinity)) break;
      all.push(`${"<>"[redo]} ${step}`);
    }
  }
  return all;
}

const parts = (line) => line.split(" ");

function restore(program, text) {
  const own = lines(program, Infinity).map(parts);
  if (own.length === mostSteps || own.some(([, , , link]) => !link)) return;  // they could not all be written and read
  const kept = text.split("\n").map(parts).filter((line) => line.length === 4);
  const [past, future] = ["<", ">"].map((mark) => kept.filter(([first]) => first === mark));
  // A polygon that was refused is opened as an edit of the last good one, which may be kept as a step already.
  if (own.length && own.at(-1)[3] === past[0]?.[3]) past.shift();
  program.call("page_forget_steps");
  for (const [mark, edit, method, link] of [...past.reverse(), ...own.reverse(), ...(own.length ? [] : future.reverse())]) {
    program.call("page_add_step", mark === ">" ? 1 : 0, Number(edit), Number(method), link);
  }
}

// The line of the method that the document is compared with, if there is one and it fits.
function comparison(program, most) {
  const method = program.number("page_compared");
  const line = method ? `= ${method} ${program.text("page_link")}` : "";
  return line && line.length < most ? [line] : [];
}

// The comparison goes on if the same document is open.
function restoreComparison(program, text) {
  const [mark, method, link] = parts(text.split("\n", 1)[0]);
  if (mark === "=" && link && link === program.text("page_link")) program.call("page_compare", Number(method));
}

// Puts the steps of the last visit before those of this one, and keeps them from now on.
export function keepHistory(program) {
  const before = read(lasting, key);
  // If they stop the page, the next start must not find them.
  write(lasting, key, "");
  if (before) restore(program, before);
  restoreComparison(program, before);

  let written;
  const keep = () => {
    let text = "";
    for (let most = mostBytes; most > 1000; most /= 4) {
      const compared = comparison(program, most);
      text = [...compared, ...lines(program, most - compared.join().length)].join("\n");
      if (text === written || write(lasting, key, text)) break;
      text = "";
    }
    written = text;
  };
  let wake;  // ends the pause
  const soon = () => {
    if (wake) return;
    underWay(new Promise((done) => {
      wake = done;
      setTimeout(done, pause);
    }).then(() => {
      wake = undefined;
      if (!program.stopped) keep();
    }));
  };
  document.addEventListener("evenlift-change", soon);
  document.addEventListener("evenlift-hurry", () => wake?.());
  addEventListener("pagehide", () => !program.stopped && keep());
  keep();
}
