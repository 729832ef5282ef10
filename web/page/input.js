// Keys, and those habits of browsers that the program's own event handling does not cover.
// `field` is the one of the mirror (web/mirror/mirror.js).
export function connectInput(program, field, { embed }) {
  const canvas = document.getElementById("canvas");
  const root = document.documentElement;
  // Before connectKeys(), which keeps keys from those that listen later.
  addEventListener("keydown", (event) => event.key === "Tab" && root.classList.add("by-key"), { capture: true });
  connectKeys(program, canvas, field);
  connectPresses(program);

  canvas.addEventListener("pointerdown", (event) => {
    root.classList.remove("by-key");
    getSelection().removeAllRanges();  // as a press anywhere does elsewhere; else Ctrl+C would copy that text
    // Preventing mousedown's default, as SDL does, also prevents the focus; and without capture a drag ends at the
    // window's edge.
    canvas.focus({ preventScroll: true });
    if (event.pointerType === "mouse") canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());

  addEventListener("wheel", (event) => {
    if (event.target !== canvas) return;
    if (event.ctrlKey) {
      // Browsers report a trackpad's pinch like this; it must not zoom the page.
      event.preventDefault();
      event.stopImmediatePropagation();
      program.call("page_pinch", event.clientX, event.clientY, Math.exp(-event.deltaY * 0.01));
    } else if (embed && document.activeElement !== canvas) {
      // In an <iframe> the wheel scrolls the article around it until the reader presses on the figure.
      event.stopImmediatePropagation();
    }
  }, { capture: true, passive: false });
}

// Tells when a press was made and how many came in a row; SDL knows only when it received the event.
function connectPresses(program) {
  for (const type of ["mousedown", "touchstart"]) {
    addEventListener(type, (event) => program.press(event.timeStamp, event.detail), { capture: true, passive: true });
  }
}

function connectKeys(program, canvas, field) {
  // The field that the program named has the focus at once, so that it gets the next key, too. A digit is the first of its number.
  const beginField = (key) => {
    if (/^[\d.,]$/.test(key)) field.begun = key;
    field.show();
  };
  // A button of the mirror leaves all keys but those of buttons to the page.
  const ofButton = (event) => event.target.matches?.("#mirror button") && !["Enter", " ", "Escape", "Tab"].includes(event.key);
  const ours = (event) => (event.target === canvas || event.target === document.body || ofButton(event)) && !document.querySelector("dialog:modal");
  addEventListener("keydown", (event) => {
    if (!ours(event)) return;
    // SDL would keep every key from the browser, so it does not get them.
    event.stopImmediatePropagation();
    if (event.altKey || event.isComposing) return;
    const command = event.ctrlKey || event.metaKey;
    const endOfLesson = event.key === "Escape" && document.querySelector("#lesson-end .away");
    if (endOfLesson) {
      event.preventDefault();
      endOfLesson.click();  // the next Escape leaves the lesson
      return;
    }
    if (command && event.key.toLowerCase() === "c" && String(getSelection())) return;
    if (program.number("page_key", event.key, command ? 1 : 0, event.shiftKey ? 1 : 0)) {
      event.preventDefault();
      if (field.awaited) beginField(event.key);
    }
    else if (event.key === "Escape") document.querySelector("dialog[open]")?.close();  // the window beside the canvas
  }, { capture: true });
  for (const type of ["keyup", "keypress"]) {
    addEventListener(type, (event) => ours(event) && event.stopImmediatePropagation(), { capture: true });
  }
}
