// What the program asks of the browser (wasm/browser.cpp).
export function createHost(publisher) {
  let screen;
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      return copyTheOldWay(text);
    }
  }

  return {
    // The screen is connected once the program runs.
    connect(connected) {
      screen = connected;
    },
    measureScreen: () => screen?.measure(),
    documentChanged: () => publisher.changed(),
    preferencesChanged: () => publisher.keepPreferences(),
    async copyAddress(link) {
      const url = new URL(location.href);
      url.search = "";
      url.hash = link;
      const done = await copy(url.href);
      publisher.notice(done ? "The link is copied. It holds the polygon and all settings."
        : "The browser did not let the page copy. The address bar holds the same link.", !done);
    },
    openDialog(name) {
      document.dispatchEvent(new CustomEvent("evenlift-dialog", { detail: name }));
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
