// What the program asks of the browser (wasm/browser.cpp), and what the page's own windows need of the page.
import { connectIntake } from "./intake.js";

// Some programs cut longer links: mail, chats, older browsers.
const longLink = 2000;

export function createHost(publisher) {
  let screen;
  let page;
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      return copyTheOldWay(text);
    }
  }

  function address(link) {
    const url = new URL(location.href);
    url.search = "";
    url.hash = link;
    return url.href;
  }

  function lengthOf(url) {
    const length = `It has ${url.length.toLocaleString("en")} characters`;
    return url.length < longLink ? `${length}; it holds the polygon and all settings.`
      : `${length}: some programs cut links from ${longLink.toLocaleString("en")} on. A file holds the same: see Save.`;
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
    // Once the program runs.
    connect(program, connected, { embed }) {
      screen = connected;
      page = { program, copy, address, lengthOf, windows, notice: (text, problem) => publisher.notice(text, problem) };
      if (!embed) connectIntake(page);
    },
    measureScreen: () => screen?.measure(),
    documentChanged() {
      publisher.changed();
      document.dispatchEvent(new Event("evenlift-change"));
    },
    preferencesChanged: () => publisher.keepPreferences(),
    async copyAddress(link) {
      const url = address(link);
      const done = await copy(url);
      publisher.notice(done ? `The link is copied. ${lengthOf(url)}`
        : "The browser did not let the page copy. The address bar holds the same link.", !done);
    },
    openDialog(name) {
      windows().then((all) => all[name](page), () => {});
    },
    announce(text) {
      document.getElementById("alert").textContent = text;
    },
    openPage() {
      publisher.flush();
      const url = new URL(location.href);
      url.search = "";
      open(url.href, "_blank", "noopener");
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
