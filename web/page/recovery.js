// The page never gets stuck. A start marks its document until the first frame. If the next start finds the mark, it
// sets that document aside. When the program stops later, the page starts again with the last drawn document.
import { translated } from "../words/words.js";
import { lasting, ofThisTab, read, write } from "./storage.js";

const markKey = "evenlift.opening";
const asideKey = "evenlift.aside";
const stoppedKey = "evenlift.stopped";
const mostAside = 5;
const mostRestarts = 3; // in a row, without any input

// Of equal length, so that one can be replaced even in a full storage.
const noMark = "-".repeat(20);
function markOf(text) {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return `${text.length.toString(16).padStart(12, "0")}${(hash >>> 0).toString(16).padStart(8, "0")}`;
}

// --- Texts that could not be opened, the newest first -------------------------------------------------------

export function textsAside() {
  try {
    const texts = JSON.parse(read(lasting, asideKey) || "[]");
    return Array.isArray(texts) ? texts.filter((text) => typeof text === "string") : [];
  } catch {
    return [];
  }
}

// Removes older texts if necessary. Returns whether the text was kept.
function setAside(text) {
  const texts = [text, ...textsAside().filter((other) => other !== text)].slice(0, mostAside);
  while (texts.length && !write(lasting, asideKey, JSON.stringify(texts))) texts.pop();
  return texts.length > 0;
}

export function forgetAside() {
  write(lasting, asideKey, "");
}

// --- A start ---------------------------------------------------------------------------------------------------------

const keptAside = "It is kept: use Save to get it as a file.";
const withKept = (sentence) => `${translated(sentence)} ${translated(keptAside)}`;

// A lock shows whether another tab is starting: then the mark is that tab's, not a failure. Without locks, two tabs
// that open at the same moment look like one that failed.
async function holdStart() {
  if (!navigator.locks) return { alone: true, release() {} };
  return new Promise((ready) => {
    navigator.locks
      .request(
        "evenlift.start",
        { ifAvailable: true },
        (lock) =>
          new Promise((release) => {
            ready({ alone: lock !== null, release });
          }),
      )
      .catch(() => ready({ alone: true, release() {} }));
  });
}

// Leaves out what stopped the last start. `kept` has the links of the fragment and the kept texts. Returns the texts to
// open, and a message about the others. If this tab's own work is left out, the last document of any tab replaces it,
// unless it is the same.
export async function beginStart(kept) {
  const start = await holdStart();
  const failed = start.alone ? read(lasting, markKey) : noMark;
  const hasFailed = (text) => text && failed === markOf(text);
  let opens = { ...kept, problem: "" };
  if (hasFailed(kept.work)) {
    for (const text of [kept.work, kept.draft]) if (text) setAside(text);
    const work = kept.last === kept.work ? "" : kept.last;
    opens = {
      ...opens,
      work,
      draft: "",
      drawing: "",
      problem: withKept("The page stopped while opening the last polygon, so it was not opened again."),
    };
  }
  for (const [part, sentence] of [
    // It may be the link of that work.
    ["fragment", "The page stopped while opening this link, so it was not opened again."],
    ["lesson", "The page stopped while opening this lesson, so it was not opened again."],
  ]) {
    if (!hasFailed(kept[part])) continue;
    setAside(kept[part]);
    opens = { ...opens, [part]: "", problem: withKept(sentence) };
  }
  // A lesson in an address is the likeliest to stop the page: everything else was drawn before.
  const opened = opens.lesson || opens.fragment || opens.work;
  const marked = opened !== "" && start.alone && write(lasting, markKey, markOf(opened));
  const unmark = () => {
    if (start.alone) write(lasting, markKey, noMark);
    start.release();
    removeEventListener("pagehide", unmark);
  };
  // A tab closed before its first frame has not failed: a stuck tab would not receive this event.
  addEventListener("pagehide", unmark);
  return {
    ...opens,
    succeeded: unmark,
    // Returns whether to start again, without the document.
    failed() {
      removeEventListener("pagehide", unmark);
      start.release();
      return marked && read(lasting, markKey) === markOf(opened);
    },
  };
}

// --- The program stops -----------------------------------------------------------------------------------------------

// "" if the page did not start again.
export function whyStartedAnew() {
  try {
    return JSON.parse(read(ofThisTab, stoppedKey) || "{}").sentence ?? "";
  } catch {
    return "";
  }
}

// After input, or when another document is opened.
export function workGoesOn() {
  if (read(ofThisTab, stoppedKey)) write(ofThisTab, stoppedKey, "");
}

// `opening` is the text that was being opened, if any; `work` is the kept work. Returns whether to load the page again.
export function prepareRestart({ opening, work }) {
  let restarts = 0;
  try {
    restarts = Number(JSON.parse(read(ofThisTab, stoppedKey) || "{}").restarts) || 0;
  } catch {
    // The state belongs to another page.
  }
  if (restarts >= mostRestarts) return false;
  // If the page stops again without any input, the kept work is the reason.
  if (restarts > 0 && work) write(lasting, markKey, markOf(work));
  const sentences = opening
    ? [
        "The page stopped while opening this, and has started again with the last polygon that was shown.",
        setAside(opening) ? keptAside : "It is too large to be kept here.",
      ]
    : ["The page stopped, and has started again with the last polygon that was shown."];
  const sentence = sentences.map(translated).join(" ");
  return write(ofThisTab, stoppedKey, JSON.stringify({ restarts: restarts + 1, sentence }));
}
