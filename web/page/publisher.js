import { readAddress, withLesson } from "./address.js";
import { lasting, ofThisTab, read, write } from "./storage.js";
import { begin, end, isAwaited, whenAwaited } from "./work.js";

// Brings what the browser keeps up to date with the document: address bar and storage a few times a second at most
// (browsers refuse more), the summary for screen readers when there is a pause.
const betweenWrites = 400;
const beforeSpeaking = 600;
const workKey = "evenlift.work";
const draftKey = "evenlift.draft";
const drawingKey = "evenlift.drawing";
const preferencesKey = "evenlift.preferences";
const addressKey = "evenlift.address";

const mostKept = 400000;  // vertices: no browser keeps a text of more

export class Publisher {
  #program = null;
  #embed;
  #lastWrite = -Infinity;
  #writeTimer = 0;
  #speakTimer = 0;
  #lesson = "";
  #held = false;
  #drawn = true;  // what is to be written
  #late = false;  // it was to be written, and waits for its picture

  constructor({ embed }) {
    this.#embed = embed;
    addEventListener("pagehide", () => this.#leave());
    document.addEventListener("visibilitychange", () => document.hidden && this.#leave());
    whenAwaited(() => {
      if (this.#writeTimer) this.#writeSoon();
      if (this.#speakTimer) this.#speakSoon();
    });
  }

  // From here on changes are published; what was opened at the start is not yet one.
  connect(program) {
    this.#program = program;
    this.#speak();
  }

  // What was open here last, and whether this fragment is only what this tab itself wrote into the address bar: then
  // the work is at least as new.
  kept(fragment) {
    if (this.#embed) return { work: "", draft: "", drawing: "", own: false };
    const work = read(lasting, workKey);
    const own = work !== "" && fragment === read(ofThisTab, addressKey);
    return { work, draft: read(lasting, draftKey), drawing: read(lasting, drawingKey), own };
  }

  // What is kept must not be opened again.
  forget() {
    for (const key of [workKey, draftKey, drawingKey]) write(lasting, key, "");
  }

  // The program stopped: nothing that it says now is to be kept. Gives what is.
  stop() {
    this.#program = null;
    clearTimeout(this.#writeTimer);
    clearTimeout(this.#speakTimer);
    this.#writeTimer = this.#speakTimer = 0;
    return this.#embed ? "" : read(lasting, workKey);
  }

  // A picture is there.
  drawn() {
    this.#drawn = true;
    if (this.#late) this.#write();
  }

  changed() {
    if (!this.#program) return;
    this.#drawn = false;
    if (!this.#writeTimer) {
      begin();
      this.#writeSoon();
    }
    if (!this.#speakTimer) begin();
    this.#speakSoon();
  }

  #writeSoon() {
    clearTimeout(this.#writeTimer);
    const wait = isAwaited() ? 0 : Math.max(0, this.#lastWrite + betweenWrites - performance.now());
    this.#writeTimer = setTimeout(() => this.#write(), wait);
  }

  #speakSoon() {
    clearTimeout(this.#speakTimer);
    this.#speakTimer = setTimeout(() => {
      this.#speakTimer = 0;
      this.#speak();
      end();
    }, isAwaited() ? 0 : beforeSpeaking);
  }

  // What this browser keeps besides the document: `name=value` lines of the program's own.
  keepPreferences() {
    if (this.#program && !this.#embed) write(lasting, preferencesKey, this.#program.text("page_kept"));
  }

  // A polygon that was being drawn goes on where it was left.
  resumeDrawing(drawing) {
    if (drawing) this.#program.call("page_resume_drawing", drawing);
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

  // Writes what is waiting to be written; with `drawn` only if its picture is there.
  flush({ drawn = false } = {}) {
    if (this.#writeTimer && (this.#drawn || !drawn)) this.#write(true);
  }

  // The last moment. The address bar takes nothing new any more; a reload would ask for the old address.
  #leave() {
    if (this.#program && this.#writeTimer) this.#keep(this.#program.text("page_link"));
  }

  notice(text, problem) {
    this.#program?.call("page_notice", text, problem ? 1 : 0);
  }

  // What has no picture yet may never get one: it is not kept before. A hidden page draws none.
  #write(atOnce = false) {
    this.#late = !this.#drawn && !document.hidden && !atOnce;
    if (this.#late) return;
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
    end();
  }

  #keep(link) {
    if (this.#embed) return;
    const large = !link && this.#program.number("page_vertex_count") > mostKept;
    if (!large) write(lasting, workKey, link || this.#program.text("page_text"));
    write(lasting, draftKey, this.#program.text("page_draft"));
    write(lasting, drawingKey, this.#program.text("page_drawing"));
  }

  #speak() {
    document.getElementById("summary").textContent = this.#program.text("page_summary");
  }
}
