import { translated } from "../words/words.js";
import { lessonLinkIn, linkIn, readAddress, withLesson } from "./address.js";
import { historyKey, lasting, ofThisTab, read, workKey, write } from "./storage.js";
import { begin, end, isAwaited, whenAwaited } from "./work.js";

// The address bar and the storage are written at most a few times a second (browsers refuse more), the summary for
// screen readers at pauses.
const betweenWrites = 400;
const beforeSpeaking = 600;
const draftKey = "evenlift.draft";
const drawingKey = "evenlift.drawing";
const preferencesKey = "evenlift.preferences";
const addressKey = "evenlift.address";
// Each is kept twice: for this tab, which continues with its own after a reload or a crash, and for the next visit in
// another tab, which continues with the latest change.
const documentKeys = [workKey, draftKey, drawingKey, historyKey];

const mostKept = 400000; // vertices; no browser keeps a longer text

// Each sentence is an element that stays as long as the sentence, so that only new ones are read out; without `aloud`
// none is. The long list of teams or robots ("Robot 3 at (…") can be read but is not announced.
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

// A browser that reloads while an address is being written may open the previous one.
const isReload = () => performance.getEntriesByType("navigation")[0]?.type === "reload";

// The work matters more than the steps that led to it. Returns whether there was room.
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
  #failed = false; // to open the address's lesson
  #changed = false; // since the start; until then the next visit continues with another tab's latest change
  #told = []; // the lines of the last news
  #switched = new Set(); // since the start
  #drawn = true; // whether the document to be written was drawn
  #late = false; // a write waits for its frame

  constructor({ embed }) {
    this.#embed = embed;
    addEventListener("pagehide", () => this.#leave());
    document.addEventListener("visibilitychange", () => document.hidden && this.#leave());
    // The browser had put this page aside, and the tab may have shown another one.
    addEventListener("pageshow", ({ persisted }) => persisted && this.adopt(linkIn(location.hash)));
    whenAwaited(() => {
      if (this.#writeTimer) this.#writeSoon();
      if (this.#speakTimer) this.#speakSoon();
    });
  }

  // Opening a document at the start is not a change.
  connect(program) {
    this.#program = program;
    this.#speak({ aloud: false });
  }

  // A tab without work begins with a copy of the last document of any tab; a duplicated tab already has a copy. `own`
  // is whether this tab wrote this fragment into the address bar; then its work is at least as new. `last` is the last
  // document of any tab.
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

  // Makes the open document, for which the fragment stands, this tab's work, whatever other tabs do.
  adopt(fragment) {
    if (this.#embed || !this.#program) return;
    this.#keepAs(this.#program.text("page_link"), `${fragment}\n${fragment}`);
  }

  // Everything already kept stays unchanged.
  keepNothing() {
    this.#embed = true;
  }

  // Prevents opening this work again.
  forget(work) {
    for (const storage of [ofThisTab, lasting])
      if (read(storage, workKey) === work) for (const key of documentKeys) write(storage, key, "");
  }

  // Nothing more of the stopped program is kept. Returns the kept work.
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

  // Once the document is drawn.
  nameInAddress() {
    if (!this.#program) return;
    this.#drawn = false;
    if (!this.#writeTimer) {
      begin();
      this.#writeSoon();
    }
    this.speakSoon();
  }

  // Perhaps only the text for screen readers changed.
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

  // The program's own `name=value` lines.
  keepPreferences() {
    if (this.#program && !this.#embed) write(lasting, preferencesKey, this.#program.text("page_kept"));
  }

  resumeDrawing(drawing) {
    if (drawing) this.#program.call("page_resume_drawing", drawing);
  }

  restorePreferences() {
    if (this.#embed) return;
    this.#program.call("page_keep", read(lasting, preferencesKey));
  }

  // "" for a lesson that no address names. The number is the learner's.
  nameLesson(name, number = 1) {
    this.#lesson = name;
    this.#number = number;
    this.nameInAddress();
  }

  // During fetching, the address keeps the lesson's name; after a failure, until the document changes.
  holdLesson(held, { failed = false } = {}) {
    this.#held = held;
    this.#failed = failed;
  }

  // As long as an address with them would open what is on the screen. Editing the polygon ends that, unless the
  // lesson's task is open.
  lesson() {
    const open = this.#program.number("page_script");
    const task = this.#program.number("page_task_is_open") === 1;
    // *All steps* puts a lesson aside and brings it back.
    if (!this.#program.number("page_walkthrough_is_open") && !task) [this.#lesson, this.#number] = ["", 1];
    return open === 2 || task ? { lesson: this.#lesson, number: this.#number } : {};
  }

  // With `drawn`, only if it was drawn.
  flush({ drawn = false } = {}) {
    if (this.#writeTimer && (this.#drawn || !drawn)) this.#write(true);
  }

  // The address bar of a page being closed cannot be changed, and a reload would use the old address.
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

  // `addresses` stand for the document; without room for it, they are links like any other.
  #keepAs(link, addresses) {
    if (this.#embed) return;
    const kept = this.#keep(link);
    if (!kept || addresses !== undefined) write(ofThisTab, addressKey, kept ? addresses : "");
  }

  // Returns whether this tab had room.
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
    // Assistive technology reads each overlay's switch, so the message reports only a change.
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
