import { readAddress, withLesson } from "./address.js";

// Brings what the browser keeps up to date with the document: address bar and storage a few times a second at most
// (browsers refuse more), the summary for screen readers when there is a pause.
const betweenWrites = 400;
const beforeSpeaking = 600;
const workKey = "evenlift.work";
const draftKey = "evenlift.draft";
const drawingKey = "evenlift.drawing";
const preferencesKey = "evenlift.preferences";
const addressKey = "evenlift.address";

// Where storage is forbidden, naming it throws.
const lasting = () => localStorage;
const ofThisTab = () => sessionStorage;

export class Publisher {
  #program = null;
  #embed;
  #lastWrite = -Infinity;
  #writeTimer = 0;
  #speakTimer = 0;
  #lesson = "";
  #held = false;

  constructor({ embed }) {
    this.#embed = embed;
    addEventListener("pagehide", () => this.#leave());
    document.addEventListener("visibilitychange", () => document.hidden && this.#leave());
  }

  // From here on changes are published; what was opened at the start is not yet one.
  connect(program) {
    this.#program = program;
    this.#speak();
  }

  // What was open here last, and whether this fragment is only what this tab itself wrote into the address bar: then
  // the work is at least as new.
  kept(fragment) {
    if (this.#embed) return { work: "", draft: "", own: false };
    const work = read(lasting, workKey);
    const own = work !== "" && fragment === read(ofThisTab, addressKey);
    return { work, draft: read(lasting, draftKey), own };
  }

  changed() {
    if (!this.#program) return;
    const wait = Math.max(0, this.#lastWrite + betweenWrites - performance.now());
    this.#writeTimer ||= setTimeout(() => this.#write(), wait);
    clearTimeout(this.#speakTimer);
    this.#speakTimer = setTimeout(() => this.#speak(), beforeSpeaking);
  }

  // What this browser keeps besides the document: `name=value` lines of the program's own.
  keepPreferences() {
    if (this.#program && !this.#embed) write(lasting, preferencesKey, this.#program.text("page_kept"));
  }

  // A polygon that was being drawn goes on where it was left.
  resumeDrawing() {
    if (!this.#embed) this.#program.call("page_resume_drawing", read(lasting, drawingKey));
  }

  restorePreferences() {
    if (this.#embed) return;
    this.#program.call("page_keep", read(lasting, preferencesKey));
  }

  // What the address calls the ready-made lesson that was just opened; "" if it has no name there.
  nameLesson(name) {
    this.#lesson = name;
    this.changed();
  }

  // While what the address asks for is being fetched, it goes on asking for it.
  holdLesson(held) {
    this.#held = held;
  }

  // The name, as long as an address with it would open what is on the screen: not once its polygon was edited.
  lesson() {
    const open = this.#program.number("page_script");
    if (!open) this.#lesson = "";
    return open === 2 ? this.#lesson : "";
  }

  // Writes what is waiting to be written.
  flush() {
    if (this.#writeTimer) this.#write();
  }

  // The last moment. The address bar takes nothing new any more; a reload would ask for the old address.
  #leave() {
    if (this.#writeTimer) this.#keep(this.#program.text("page_link"));
  }

  notice(text, problem) {
    this.#program?.call("page_notice", text, problem ? 1 : 0);
  }

  #write() {
    clearTimeout(this.#writeTimer);
    this.#writeTimer = 0;
    this.#lastWrite = performance.now();
    const link = this.#program.text("page_link");
    // A polygon too large for a link leaves an address without one: an old link would be a lie.
    const challenge = readAddress().challenge && this.#program.number("page_lesson_is_open") === 1;
    const url = new URL(location.href);
    if (!this.#held) withLesson(url, { lesson: this.lesson(), challenge });
    url.hash = link;
    if (url.href !== location.href) history.replaceState(history.state, "", url);
    this.#keep(link);
    if (!this.#embed) write(ofThisTab, addressKey, link);
  }

  #keep(link) {
    if (this.#embed) return;
    write(lasting, workKey, link || this.#program.text("page_text"));
    write(lasting, draftKey, this.#program.text("page_draft"));
    write(lasting, drawingKey, this.#program.text("page_drawing"));
  }

  #speak() {
    document.getElementById("summary").textContent = this.#program.text("page_summary");
  }
}

// Storage may be full, or forbidden altogether; the page works without.
function read(storage, key) {
  try {
    return storage().getItem(key) ?? "";
  } catch {
    return "";
  }
}

function write(storage, key, text) {
  try {
    if (text) storage().setItem(key, text);
    else storage().removeItem(key);
  } catch {
    // The address bar still holds the work.
  }
}
