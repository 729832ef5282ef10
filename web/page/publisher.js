import { translated } from "../words/words.js";
import { lessonLinkIn, linkIn, readAddress, withLesson } from "./address.js";
import { historyKey, lasting, ofThisTab, read, workKey, write } from "./storage.js";
import { begin, end, isAwaited, whenAwaited } from "./work.js";

// Keeps the browser up to date with the document. The address bar and the storage are written at most a few times a
// second (browsers refuse more), the summary for screen readers when there is a pause.
const betweenWrites = 400;
const beforeSpeaking = 600;
const draftKey = "evenlift.draft";
const drawingKey = "evenlift.drawing";
const preferencesKey = "evenlift.preferences";
const addressKey = "evenlift.address";
// The parts of a document that are kept. Each is kept twice: for this tab, which continues with its own after a reload
// or a crash, and for the next visit in another tab, which continues with the latest change.
const documentKeys = [workKey, draftKey, drawingKey, historyKey];

const mostKept = 400000; // vertices; no browser keeps a longer text

// Each sentence is an element of its own, which stays as long as the sentence does, so that only new sentences are read
// out. The list of teams or robots ("Robot 3 at (…") is long: it can be read but is not announced. The sentences of the
// start are not announced either.
function showSentences(root, sentences, aloud) {
  const stays = new Set(sentences);
  const before = [...root.children].filter((element) => stays.has(element.textContent) || element.remove());
  sentences.forEach((text, i) => {
    if (root.children[i]?.textContent === text) return;
    const known = before.findIndex(
      (element) => element.textContent === text && [...root.children].indexOf(element) > i,
    );
    const element = known < 0 ? document.createElement("span") : before[known];
    if (known < 0) {
      element.ariaLive = !aloud || /^ \p{L}+ \d+ \p{L}+ \(/u.test(text) ? "off" : "polite";
      element.textContent = text;
    }
    root.insertBefore(element, root.children[i] ?? null);
  });
  while (root.children.length > sentences.length) root.lastChild.remove();
}

// A browser that reloads while an address is being written may still open the previous address.
const isReload = () => performance.getEntriesByType("navigation")[0]?.type === "reload";

// Keeps the work, which matters more than the steps that led to it. Returns whether there was room for it.
function keepWork(storage, work) {
  return write(storage, workKey, work) || (write(storage, historyKey, "") && write(storage, workKey, work));
}

export class Publisher {
  #program = null;
  #embed;
  #lastWrite = -Infinity;
  #writeTimer = 0;
  #speakTimer = 0;
  #lesson = "";
  #number = 1; // the learner's
  #held = false;
  #failed = false; // the lesson of the address could not be opened
  #changed = false; // since the start; until then the next visit continues with the latest change of another tab
  #told = []; // the lines of the last news
  #switched = new Set(); // the overlays that were shown or hidden since the start
  #drawn = true; // whether the document to be written was drawn
  #late = false; // a write is due, and waits for its frame

  constructor({ embed }) {
    this.#embed = embed;
    addEventListener("pagehide", () => this.#leave());
    document.addEventListener("visibilitychange", () => document.hidden && this.#leave());
    // The browser had put this page aside, and meanwhile the tab may have shown another one.
    addEventListener("pageshow", ({ persisted }) => persisted && this.adopt(linkIn(location.hash)));
    whenAwaited(() => {
      if (this.#writeTimer) this.#writeSoon();
      if (this.#speakTimer) this.#speakSoon();
    });
  }

  // From now on changes are published. Opening a document at the start is not a change.
  connect(program) {
    this.#program = program;
    this.#speak({ aloud: false });
  }

  // The work of this tab. A tab without work begins with a copy of the last document of any tab; a duplicated tab
  // already has a copy of the other's work. `own` is whether this tab itself wrote this fragment into the address bar;
  // then its work is at least as new. `last` is the last document, from whichever tab.
  kept(fragment) {
    if (this.#embed) return { work: "", draft: "", drawing: "", own: false, last: "" };
    if (!read(ofThisTab, workKey)) for (const key of documentKeys) write(ofThisTab, key, read(lasting, key));
    const work = read(ofThisTab, workKey);
    const [last, before] = read(ofThisTab, addressKey).split("\n");
    const own = work !== "" && (fragment === last || (isReload() && fragment === before));
    return {
      work,
      draft: read(ofThisTab, draftKey),
      drawing: read(ofThisTab, drawingKey),
      own,
      last: read(lasting, workKey),
    };
  }

  // Makes the open document the work of this tab, whatever other tabs do. This fragment of the address stands for it.
  adopt(fragment) {
    if (this.#embed || !this.#program) return;
    this.#keepAs(this.#program.text("page_link"), `${fragment}\n${fragment}`);
  }

  // From now on nothing is kept, and everything already kept stays unchanged.
  keepNothing() {
    this.#embed = true;
  }

  // Removes this work, so that it is not opened again.
  forget(work) {
    for (const storage of [ofThisTab, lasting])
      if (read(storage, workKey) === work) for (const key of documentKeys) write(storage, key, "");
  }

  // The program stopped: from now on nothing from it is kept. Returns the kept work.
  stop() {
    this.#program = null;
    clearTimeout(this.#writeTimer);
    clearTimeout(this.#speakTimer);
    this.#writeTimer = this.#speakTimer = 0;
    return this.#embed ? "" : read(ofThisTab, workKey);
  }

  // Call this after each frame.
  drawn() {
    this.#drawn = true;
    if (this.#late) this.#write();
  }

  changed() {
    this.#changed ||= Boolean(this.#program);
    if (this.#failed) this.holdLesson(false);
    this.nameInAddress();
  }

  // Puts the open document into the address, once it is drawn.
  nameInAddress() {
    if (!this.#program) return;
    this.#drawn = false;
    if (!this.#writeTimer) {
      begin();
      this.#writeSoon();
    }
    this.speakSoon();
  }

  // The text for screen readers changed, and perhaps nothing else.
  speakSoon() {
    if (!this.#program) return;
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
    this.#speakTimer = setTimeout(
      () => {
        this.#speakTimer = 0;
        this.#speak();
        end();
      },
      isAwaited() ? 0 : beforeSpeaking,
    );
  }

  // Keeps the preferences: the program's own `name=value` lines.
  keepPreferences() {
    if (this.#program && !this.#embed) write(lasting, preferencesKey, this.#program.text("page_kept"));
  }

  // Continues a polygon that was being drawn.
  resumeDrawing(drawing) {
    if (drawing) this.#program.call("page_resume_drawing", drawing);
  }

  restorePreferences() {
    if (this.#embed) return;
    this.#program.call("page_keep", read(lasting, preferencesKey));
  }

  // Sets the name of the lesson in an address, "" if it has none, and the learner's number.
  nameLesson(name, number = 1) {
    this.#lesson = name;
    this.#number = number;
    this.nameInAddress();
  }

  // While the lesson of the address is being fetched, the address keeps its name; after a failure, until the document
  // changes.
  holdLesson(held, { failed = false } = {}) {
    this.#held = held;
    this.#failed = failed;
  }

  // The lesson's name and the learner's number, as long as an address with them would open what is on the screen. Editing
  // its polygon ends that, but not where the lesson's task is open.
  lesson() {
    const open = this.#program.number("page_script");
    const task = this.#program.number("page_task_is_open") === 1;
    // *All steps* puts a lesson aside and brings it back.
    if (!this.#program.number("page_walkthrough_is_open") && !task) [this.#lesson, this.#number] = ["", 1];
    return open === 2 || task ? { lesson: this.#lesson, number: this.#number } : {};
  }

  // Writes anything still to be written; with `drawn`, only if it was drawn.
  flush({ drawn = false } = {}) {
    if (this.#writeTimer && (this.#drawn || !drawn)) this.#write(true);
  }

  // The page is being closed. The address bar cannot be changed any more; a reload would use the old address.
  #leave() {
    if (this.#program && this.#writeTimer) this.#keepAs(this.#program.text("page_link"));
  }

  notice(text, problem) {
    this.#program?.call("page_notice", text, problem ? 1 : 0);
  }

  // A document may stop the program, so it is kept only after it was drawn. A hidden page draws nothing.
  #write(atOnce = false) {
    this.#late = !this.#drawn && !document.hidden && !atOnce;
    if (this.#late) return;
    clearTimeout(this.#writeTimer);
    this.#writeTimer = 0;
    this.#lastWrite = performance.now();
    const link = this.#program.text("page_link");
    // If the polygon is too large for a link, the address has none: an old link would be wrong.
    const challenge = readAddress().challenge && this.#program.number("page_walkthrough_is_open") === 1;
    const url = new URL(location.href),
      before = linkIn(url.hash);
    url.hash = [link, this.#held && lessonLinkIn(url.hash)].filter(Boolean).join("&");
    if (!this.#held) withLesson(url, { ...this.lesson(), challenge });
    if (url.href !== location.href) history.replaceState(history.state, "", url);
    this.#keepAs(link, `${link}\n${before}`);
    end();
  }

  // Keeps the document, and the addresses that stand for it. If there is no room for it, they are links like any other.
  #keepAs(link, addresses) {
    if (this.#embed) return;
    const kept = this.#keep(link);
    if (!kept || addresses !== undefined) write(ofThisTab, addressKey, kept ? addresses : "");
  }

  // Keeps the document. Returns whether there was room for it in this tab.
  #keep(link) {
    const large = !link && this.#program.number("page_vertex_count") > mostKept;
    const work = large ? "" : link || this.#program.text("page_text");
    const [draft, drawing] = ["page_draft", "page_drawing"].map((name) => this.#program.text(name));
    let kept = false;
    for (const storage of this.#changed ? [lasting, ofThisTab] : [ofThisTab]) {
      kept = !large && keepWork(storage, work);
      write(storage, draftKey, kept ? draft : "");
      write(storage, drawingKey, drawing);
    }
    document.dispatchEvent(new Event("evenlift-kept"));
    return kept;
  }

  #speak({ aloud = true } = {}) {
    const sentences = this.#program.text("page_summary").split(/(?<=[.!?]) (?=[\p{Lu}\d])/u);
    showSentences(
      document.getElementById("summary"),
      sentences.map((text, i) => (i ? ` ${text}` : text)),
      true,
    );
    document.title = sentences[0] ? `${sentences[0].replace(/[.:]$/, "")} – evenlift` : "evenlift";
    // Assistive technology can read the state of each overlay's switch. The message reports only that a switch changed.
    const news = this.#program.text("page_news").split("\n").filter(Boolean);
    const switched = ["Shown: {overlay}.", "Hidden: {overlay}."].map((pattern) =>
      translated(pattern).split("{overlay}"),
    );
    const overlay = (line) =>
      switched
        .filter(([before, after]) => line.startsWith(before) && line.endsWith(after))
        .map(([before, after]) => line.slice(before.length, line.length - after.length))[0];
    for (const line of news)
      if (aloud && overlay(line) && !this.#told.includes(line)) this.#switched.add(overlay(line));
    this.#told = news;
    showSentences(
      document.getElementById("news"),
      news.filter((line) => !overlay(line) || this.#switched.has(overlay(line))),
      aloud,
    );
  }
}
