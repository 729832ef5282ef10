// The functions of the browser that the program calls (wasm/page/browser.cpp), and those of the page that its windows call.
import { readAddress, withLesson } from "./address.js";
import { connectDropAndPaste } from "./drop_and_paste.js";
import { createSearch } from "./search.js";
import { underWay } from "./under_way.js";
import { begin, end } from "./work.js";

// Mail programs, chats and older browsers may cut longer links.
const longLink = 2000;

// Calls `onFrame` after each picture.
export function createBindings(publisher, field, onFrame) {
  const canvas = document.getElementById("canvas");
  let running;  // the program
  let screen;
  let page;
  let alarm = 0;
  const search = createSearch((name, ...given) => {
    if (!running.stopped) running.call(name, ...given);
  });
  function dropFrameAfter() {
    if (!alarm) return;
    clearTimeout(alarm);
    alarm = 0;
    end();
  }

  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      return copyTheOldWay(text);
    }
  }

  function address(link, challenge = false) {
    const url = new URL(location.href);
    url.search = "";
    url.hash = link;
    return withLesson(url, { lesson: publisher.lesson(), challenge }).href;
  }

  // What the link holds or lacks, and then how long it is.
  function aboutLink(url) {
    const ownWords = running.number("page_script") && !publisher.lesson();
    const lacking = [running.text("page_link_lacks"), ownWords ? "It does not hold the words of this lesson, which came from a file." : ""];
    const holds = lacking.filter(Boolean).join(" ") || "It holds the polygon and all settings.";
    const length = `It has ${url.length.toLocaleString("en")} characters`;
    if (url.length < longLink) return `${holds} ${length}.`;
    return `${holds} ${length}: some programs cut links from ${longLink.toLocaleString("en")} on. The JSON file in Save holds the same.`;
  }

  async function windows() {
    try {
      return await import("./windows.js");
    } catch (error) {
      publisher.notice("This window cannot be loaded: the server cannot be reached.", true);
      throw error;
    }
  }

  return {
    // Call this before the first call into the program.
    attach(program) {
      running = program;
    },
    // Call this once the program runs.
    connect(program, connected, { embed }) {
      screen = connected;
      page = {
        program, copy, address, aboutLink, windows,
        notice: (text, problem) => publisher.notice(text, problem),
        nameLesson: (name) => publisher.nameLesson(name),
      };
      if (!embed) connectDropAndPaste(page);
      document.addEventListener("fullscreenchange", () => {
        if (!document.fullscreenElement) running.call("page_end_presenting");
      });
    },
    // Opens the lesson and the challenge that the address asks for; with `join`, for the document that is open.
    async beginLesson(join) {
      const { lesson, challenge } = readAddress();
      if (!lesson && !challenge) return;
      publisher.holdLesson(true);
      const all = await underWay(windows()).catch(() => undefined);
      if (all) await underWay(all.beginFromAddress(page, { lesson, challenge, join }));
      publisher.holdLesson(false);
    },
    measureScreen: () => screen?.measure(),
    scheduleFrame() {
      begin();
      requestAnimationFrame(() => {
        try {
          running.call("page_frame");
        } catch {
          return;  // the program has stopped, and the page knows
        }
        onFrame();
        end();
      });
    },
    frameAfter(seconds) {
      dropFrameAfter();
      begin();
      alarm = setTimeout(() => {
        dropFrameAfter();
        running.call("page_wake");
      }, seconds * 1000 + 1);
    },
    dropFrameAfter,
    beginSearch: (...given) => search.begin(...given),
    endSearch: () => search.end(),
    documentChanged() {
      publisher.changed();
      document.dispatchEvent(new Event("evenlift-change"));
    },
    summaryChanged: () => publisher.speakSoon(),
    preferencesChanged: () => publisher.keepPreferences(),
    async copyAddress(link) {
      const url = address(link);
      const done = await underWay(copy(url));
      publisher.notice(done ? `The link is copied. ${aboutLink(url)}`
        : "The browser did not let the page copy. The address bar holds the same link.", !done);
    },
    openDialog(name) {
      underWay(windows().then((all) => all[name](page)).catch(() => {}));
    },
    showCursor(name) {
      canvas.dataset.cursor = name;
    },
    // The fonts with the letters of other languages and mathematics. Without them a "?" stands for each.
    fetchLetters() {
      const font = async (name) => {
        const answer = await fetch(name);
        if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
        return new Uint8Array(await answer.arrayBuffer());
      };
      underWay(Promise.all(["letters-regular.otf", "letters-semibold.otf"].map(font))
        .then((fonts) => running.call("page_letters", ...fonts))
        .catch(() => publisher.notice("Some letters cannot be shown: the server cannot be reached.", true)));
    },
    sayAbsent(characters) {
      const codes = [...characters].slice(0, 5).map((c) => `U+${c.codePointAt(0).toString(16).toUpperCase().padStart(4, "0")}`);
      publisher.notice(`Some characters cannot be shown on the canvas: ${codes.join(", ")}${[...characters].length > 5 ? ", …" : ""}.`, true);
    },
    typeValue(control) {
      field.awaited = control;
    },
    announce(text) {
      document.getElementById("alert").textContent = text;
    },
    // A browser that refuses full screen shows the same in its window.
    showFullScreen(on) {
      if (on) document.documentElement.requestFullscreen?.().catch(() => {});
      else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
    },
    openPage() {
      publisher.flush();
      const { challenge } = readAddress();
      open(address(location.hash.slice(1), challenge), "_blank", "noopener");
    },
  };
}

// Where the clipboard's own interface is refused: pages that are not served securely, frames without permission.
function copyTheOldWay(text) {
  const onCopy = (event) => {
    event.clipboardData.setData("text/plain", text);
    event.preventDefault();
  };
  document.addEventListener("copy", onCopy, { once: true });
  try {
    return document.execCommand("copy");
  } catch {
    return false;
  } finally {
    document.removeEventListener("copy", onCopy);
  }
}
