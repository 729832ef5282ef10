// The page never stays stuck. What a start opens is marked until its first picture is there; a mark that is still there at
// the next start says that the page did not get so far, and then that document is not opened again but set aside. When
// the program stops later, the page starts anew with the last document that was drawn.
import { lasting, ofThisTab, read, write } from "./storage.js";

const markKey = "evenlift.opening";
const asideKey = "evenlift.aside";
const stoppedKey = "evenlift.stopped";
const mostAside = 5;
const mostRestarts = 3;  // without anybody doing anything in between

// Always of the same length, so that a mark fits even where storage is full.
const noMark = "-".repeat(20);
function markOf(text) {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return `${text.length.toString(16).padStart(12, "0")}${(hash >>> 0).toString(16).padStart(8, "0")}`;
}

// --- What could not be opened: kept as texts, the newest first -------------------------------------------------------

export function textsAside() {
  try {
    const texts = JSON.parse(read(lasting, asideKey) || "[]");
    return Array.isArray(texts) ? texts.filter((text) => typeof text === "string") : [];
  } catch {
    return [];
  }
}

// Whether it could be kept; older ones make room for it.
function setAside(text) {
  const texts = [text, ...textsAside().filter((other) => other !== text)].slice(0, mostAside);
  while (texts.length && !write(lasting, asideKey, JSON.stringify(texts))) texts.pop();
  return texts.length > 0;
}

export function forgetAside() {
  write(lasting, asideKey, "");
}

// --- A start ---------------------------------------------------------------------------------------------------------

const keptAside = "It is kept: Save has it as a file.";

// Another tab that is starting just now has set the mark. Locks tell; where there are none, two tabs that are opened in
// the same moment are taken for one that failed.
async function holdStart() {
  if (!navigator.locks) return { alone: true, release() {} };
  return new Promise((ready) => {
    navigator.locks.request("evenlift.start", { ifAvailable: true }, (lock) => new Promise((release) => {
      ready({ alone: lock !== null, release });
    })).catch(() => ready({ alone: true, release() {} }));
  });
}

// Looks at what is to be opened, and leaves out what the last start did not survive. `kept` has the fragment's link and
// the kept texts; gives what of it to open, and a sentence about the rest.
export async function beginStart(kept) {
  const start = await holdStart();
  const failed = start.alone ? read(lasting, markKey) : noMark;
  let opens = { ...kept, problem: "" };
  if (kept.fragment && failed === markOf(kept.fragment)) {
    setAside(kept.fragment);
    opens = { ...opens, fragment: "", problem: `The page stopped when this link was opened, so it is not opened again. ${keptAside}` };
  } else if (kept.work && failed === markOf(kept.work)) {
    for (const text of [kept.work, kept.draft]) if (text) setAside(text);
    opens = { ...opens, work: "", draft: "", drawing: "", problem: `The page stopped when the last polygon was opened, so it is not opened again. ${keptAside}` };
  }
  const opened = opens.fragment || opens.work;
  const marked = opened !== "" && start.alone && write(lasting, markKey, markOf(opened));
  const unmark = () => {
    if (start.alone) write(lasting, markKey, noMark);
    start.release();
    removeEventListener("pagehide", unmark);
  };
  // A tab that is closed before it ever showed a picture has not failed: a stuck one would not hear of it.
  addEventListener("pagehide", unmark);
  return {
    ...opens,
    succeeded: unmark,
    // Whether to start again, now without what was opened.
    failed() {
      removeEventListener("pagehide", unmark);
      start.release();
      return marked && read(lasting, markKey) === markOf(opened);
    },
  };
}

// --- The program stops -----------------------------------------------------------------------------------------------

// What a page that starts anew has to say; nothing if it does not.
export function whyStartedAnew() {
  try {
    return JSON.parse(read(ofThisTab, stoppedKey) || "{}").sentence ?? "";
  } catch {
    return "";
  }
}

// Once somebody has done something, or another document is asked for, stopping again is another matter.
export function workGoesOn() {
  if (read(ofThisTab, stoppedKey)) write(ofThisTab, stoppedKey, "");
}

// Called when the program stopped. `opening` is the text that was being opened, if one was; `work` what is kept. Whether
// to load the page again.
export function prepareRestart({ opening, work }) {
  let restarts = 0;
  try {
    restarts = Number(JSON.parse(read(ofThisTab, stoppedKey) || "{}").restarts) || 0;
  } catch {
    // Somebody else's.
  }
  if (restarts >= mostRestarts) return false;
  // What stops the page again with nobody doing anything is what is kept.
  if (restarts > 0 && work) write(lasting, markKey, markOf(work));
  const aside = opening ? setAside(opening) ? ` ${keptAside}` : " It is too large to be kept here." : "";
  const sentence = opening ? `The page stopped when this was opened, and has started anew with the last polygon that was shown.${aside}`
    : "The page stopped, and has started anew with the last polygon that was shown.";
  return write(ofThisTab, stoppedKey, JSON.stringify({ restarts: restarts + 1, sentence }));
}
