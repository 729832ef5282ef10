// Functions that the program calls (wasm/page/sdl_input.cpp), and functions of the page for its windows.
import { number } from "../words/numbers.js";
import { say, translated } from "../words/words.js";
import { isLessonLink, linkIn, readAddress, withLesson, withPlaces } from "./address.js";
import { createChoosing } from "./choosing.js";
import { copy } from "./clipboard.js";
import { connectDropAndPaste } from "./drop_and_paste.js";
import { createSearch } from "./search.js";
import { underWay } from "./under_way.js";
import { begin, end } from "./work.js";

// Writings that the fonts lack.
const writings = {
  Han: "Chinese characters",
  Hiragana: "Japanese letters",
  Katakana: "Japanese letters",
  Hangul: "Korean letters",
  Arabic: "Arabic letters",
  Hebrew: "Hebrew letters",
  Devanagari: "Devanagari letters",
  Thai: "Thai letters",
};
const writingOf = Object.entries(writings).map(([script, name]) => [new RegExp(`\\p{Script=${script}}`, "u"), name]);

function nameOf(character) {
  const writing = writingOf.find(([pattern]) => pattern.test(character));
  if (writing) return writing[1];
  if (/\p{Extended_Pictographic}/u.test(character)) return "emoji";
  return `U+${character.codePointAt(0).toString(16).toUpperCase().padStart(4, "0")}`;
}

// Mail programs, chats and older browsers may cut longer links.
const longLink = 2000;

async function fetchBytes(name) {
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  return new Uint8Array(await answer.arrayBuffer());
}

export class Bindings {
  #canvas = document.getElementById("canvas");
  #publisher;
  #field;
  #onFrame;
  #search;
  #choose;
  #program;
  #screen;
  #page; // as its windows get it
  #pictures = new EventTarget();
  #alarm = 0;
  #noticeEnd = 0;

  // A key that asks for a field puts its name into `field.awaited`. `onFrame` is called after each frame.
  constructor(publisher, field, onFrame) {
    this.#publisher = publisher;
    this.#field = field;
    this.#onFrame = onFrame;
    const call = (name, ...given) => {
      if (!this.#program.stopped) this.#program.call(name, ...given);
    };
    this.#search = createSearch(call);
    this.#choose = createChoosing(call);
  }

  // Call this before the first call into the program.
  attach(program) {
    this.#program = program;
  }

  // Call this once the program runs.
  connect(program, screen, { embed }) {
    this.#screen = screen;
    this.#page = {
      program,
      copy,
      address: (link, challenge) => this.#address(link, challenge),
      sharedAddress: (link) => this.#sharedAddress(link),
      placesAddress: (link, challenge) => this.#placesAddress(link, challenge),
      lessonAddress: (lesson) => this.#lessonAddress(lesson),
      leavePlaces: () => history.replaceState(history.state, "", withPlaces(new URL(location.href))),
      aboutLink: (url) => this.#aboutLink(url),
      windows: () => this.#windows(),
      notice: (text, problem) => this.#publisher.notice(text, problem),
      announce: (text) => this.announce(text), // for screen readers, without showing it
      pictures: this.#pictures, // gets "drawn" after each frame of the program
      nameLesson: (name, number) => this.#publisher.nameLesson(name, number),
    };
    if (!embed) connectDropAndPaste(this.#page);
    document.addEventListener("fullscreenchange", () => {
      if (!document.fullscreenElement) program.call("page_end_presenting");
    });
  }

  // Opens the lesson and the challenge of the address; with `join`, for the open document.
  async beginLesson(join) {
    const { lesson, number, challenge, place, beat } = readAddress();
    if (place && !lesson) {
      this.#program.call("page_set_challenge", 1);
      const all = await underWay(this.#windows()).catch(() => undefined);
      if (all) await underWay(all.challenge(this.#page, { place, beat }));
      return;
    }
    if (!lesson && !challenge) return;
    this.#publisher.holdLesson(true);
    const all = await underWay(this.#windows()).catch(() => undefined);
    const opens = all && (await underWay(all.beginFromAddress(this.#page, { lesson, number, challenge, join })));
    const failed = isLessonLink(lesson) && !opens;
    this.#publisher.holdLesson(failed, { failed });
  }

  // --- Frames --------------------------------------------------------------------------------------------------------

  measureScreen() {
    this.#screen?.measure();
  }

  scheduleFrame() {
    begin();
    requestAnimationFrame(() => {
      try {
        this.#program.call("page_frame");
      } catch {
        return; // the program has stopped, and the page knows
      }
      this.#onFrame();
      this.#enlarge();
      this.#pictures.dispatchEvent(new Event("drawn"));
      end();
    });
  }

  // Presentation mode enlarges the windows as it does the canvas (dialogs.css).
  #enlarge() {
    const zoom = String(this.#program.number("page_zoom"));
    const { style } = document.documentElement;
    if ((style.getPropertyValue("--zoom") || "1") !== zoom) style.setProperty("--zoom", zoom);
  }

  frameAfter(seconds) {
    this.dropFrameAfter();
    begin();
    this.#alarm = setTimeout(
      () => {
        this.dropFrameAfter();
        this.#program.call("page_wake");
      },
      seconds * 1000 + 1,
    );
  }

  // Nothing waits for this timer, so it is not work under way. Below 0 seconds, the notice stays.
  endNoticeAfter(seconds) {
    clearTimeout(this.#noticeEnd);
    if (seconds >= 0) this.#noticeEnd = setTimeout(() => this.#program.call("page_end_notice"), seconds * 1000);
  }

  dropFrameAfter() {
    if (!this.#alarm) return;
    clearTimeout(this.#alarm);
    this.#alarm = 0;
    end();
  }

  showCursor(name) {
    this.#canvas.dataset.cursor = name;
  }

  // A browser that refuses shows the same in its window.
  showFullScreen(on) {
    if (on) document.documentElement.requestFullscreen?.().catch(() => {});
    else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
  }

  // For other languages and mathematics; without these fonts, such letters appear as "?".
  fetchLetters() {
    underWay(
      Promise.all([fetchBytes("letters-regular.otf"), fetchBytes("letters-semibold.otf")])
        .then(([regular, semibold]) => this.#program.call("page_letters", regular, semibold))
        .catch(() => this.#publisher.notice("Some letters cannot be shown: the server cannot be reached.", true)),
    );
  }

  sayAbsent(characters) {
    const all = [...new Set([...characters].map(nameOf))];
    const names = `${all.slice(0, 5).map(translated).join(", ")}${all.length > 5 ? ", …" : ""}`;
    this.#publisher.notice(say("Some characters cannot be shown on the canvas: {names}.", { names }), true);
  }

  // --- The document --------------------------------------------------------------------------------------------------

  documentChanged() {
    this.#publisher.changed();
    document.dispatchEvent(new Event("evenlift-change"));
  }

  summaryChanged() {
    this.#publisher.speakSoon();
  }

  preferencesChanged() {
    this.#publisher.keepPreferences();
  }

  announce(text) {
    const region = document.getElementById("alert");
    const said = translated(text);
    // A screen reader does not repeat an unchanged text.
    region.textContent = said && region.textContent === said ? `${said}\u00a0` : said;
  }

  beginSearch(...given) {
    this.#search.begin(...given);
  }

  endSearch() {
    this.#search.end();
  }

  chooseElsewhere(...given) {
    this.#choose(...given);
  }

  // --- Links and windows ---------------------------------------------------------------------------------------------

  // In a task, the link of the task as it begins: the result is copied by the task's own button.
  async copyAddress(link) {
    const url = this.#sharedAddress(link);
    const done = await underWay(copy(url));
    this.#publisher.notice(
      done
        ? `${translated("The link is copied.")} ${this.#aboutLink(url)}`
        : "The browser did not allow copying. Share and save shows the same link.",
      !done,
    );
  }

  openPage() {
    this.#publisher.flush();
    const { challenge } = readAddress();
    open(this.#address(linkIn(location.hash), challenge), "_blank", "noopener");
  }

  // Settles when it is open, or cannot be.
  openDialog(name) {
    return underWay(
      this.#windows()
        .then((all) => all[name](this.#page))
        .catch(() => {}),
    );
  }

  typeValue(control) {
    this.#field.awaited = control;
  }

  #address(link, challenge = false) {
    const url = new URL(location.href);
    url.search = "";
    url.hash = link;
    return withLesson(url, { ...this.#publisher.lesson(), challenge }).href;
  }

  // A task is shared as it begins.
  #sharedAddress(link) {
    const isTask = this.#program.number("page_task_is_open") === 1 && this.#publisher.lesson().lesson;
    return this.#address(isTask ? "" : link);
  }

  // Of a lesson that is a link, alone.
  #lessonAddress(lesson) {
    const url = new URL(location.href);
    url.search = url.hash = "";
    return withLesson(url, { lesson }).href;
  }

  #placesAddress(link, challenge) {
    const url = new URL(location.href);
    url.search = "";
    url.hash = link;
    return withPlaces(url, challenge).href;
  }

  // The link's contents and omissions, then its length.
  #aboutLink(url) {
    const { lesson } = this.#publisher.lesson();
    if (lesson && !linkIn(new URL(url).hash))
      return translated("It holds the task as it begins, without what you did: “Copy result” copies that.");
    const ownWords = this.#program.number("page_script") && !lesson;
    const lacking = [
      this.#program.text("page_link_lacks"),
      ownWords
        ? translated(
            "It does not hold the words of this lesson: send the lesson’s file as well, or copy the link to it in the editor.",
          )
        : "",
    ];
    const [all, instead] = isLessonLink(lesson)
      ? ["It holds the polygon, all settings and the whole lesson.", "The lesson’s file holds the same."]
      : ["It holds the polygon and all settings.", "The JSON file in Save holds the same."];
    const holds = lacking.filter(Boolean).join(" ") || translated(all);
    const [characters, most] = [url.length, longLink].map(number);
    if (url.length < longLink) return `${holds} ${say("It has {number} characters.", { number: characters })}`;
    const cut = say("It has {number} characters: some programs cut links of {most} or more.", {
      number: characters,
      most,
    });
    return `${holds} ${cut} ${translated(instead)}`;
  }

  async #windows() {
    try {
      return await import("./windows.js");
    } catch (error) {
      this.#publisher.notice("This window cannot be loaded: the server cannot be reached.", true);
      throw error;
    }
  }
}
