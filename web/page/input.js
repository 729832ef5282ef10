// Keys, and browser behaviour that the program's event handling does not cover.
const root = document.documentElement;

// A figure in an article is a guest, which leaves the wheel, fingers and keys to the article, until the reader gives it
// the focus by a click, a tap or Tab, and again after Esc or when the reader moves elsewhere. page.css uses this class.
const isGuest = () => root.classList.contains("guest");

function takeHold(canvas) {
  canvas.focus({ preventScroll: true });
  root.classList.remove("guest"); // it may have had the focus in its own window
}

function letGo() {
  document.activeElement?.blur();
  root.classList.add("guest");
}

// `field` is the mirror's (web/mirror/mirror.js).
export function connectInput(program, field, { embed }) {
  const canvas = document.getElementById("canvas");
  if (embed) connectGuest(canvas);
  // Before connectKeys(), which hides keys from later listeners.
  addEventListener("keydown", (event) => event.key === "Tab" && root.classList.add("by-key"), { capture: true });
  connectKeys(program, canvas, field, { embed });
  connectPresses(program);
  connectAsking(program);

  canvas.addEventListener("pointerdown", (event) => {
    if (isGuest() && event.pointerType !== "mouse") return; // it may become a swipe
    root.classList.remove("by-key");
    getSelection().removeAllRanges(); // as elsewhere; else Ctrl+C would copy that text
    // SDL prevents the default of mousedown, and so the focus. Without capture, a drag ends at the window's edge.
    takeHold(canvas);
    if (event.pointerType === "mouse") canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());

  addEventListener(
    "wheel",
    (event) => {
      if (event.target !== canvas) return;
      if (isGuest()) {
        event.stopImmediatePropagation();
      } else if (event.ctrlKey) {
        // Browsers report a trackpad's pinch as a wheel event with Ctrl; it must not zoom the page.
        event.preventDefault();
        event.stopImmediatePropagation();
        program.call("page_pinch", event.clientX, event.clientY, Math.exp(-event.deltaY * 0.01));
      }
    },
    { capture: true, passive: false },
  );
}

function connectGuest(canvas) {
  const hold = (held) => root.classList.toggle("guest", !held);
  addEventListener("focusin", () => hold(true));
  // The window's events: the focus returns to its former place, or moves to the article.
  addEventListener("focus", () => hold(document.activeElement !== document.body));
  addEventListener("blur", () => hold(false));
  canvas.addEventListener("click", () => isGuest() && takeHold(canvas)); // from a pen, for example
  connectTaps(canvas);
}

// SDL would hide every touch from the browser, so it gets none of a guest's, except a tap, which takes hold of the
// figure.
const mostOfTap = 10; // CSS pixels

function connectTaps(canvas) {
  let withheld = false; // the fingers arrived while the figure was a guest
  let press; // may become a tap
  const pass = (type, touch) => {
    const touches = type === "touchstart" ? [touch] : [];
    canvas.dispatchEvent(
      new TouchEvent(type, {
        touches,
        targetTouches: touches,
        changedTouches: [touch],
        bubbles: true,
        cancelable: true,
      }),
    );
  };
  const follow = {
    touchstart({ touches, changedTouches: [touch] }) {
      press = touches.length === 1 ? touch : undefined;
    },
    touchmove({ changedTouches: [touch] }) {
      if (press && Math.hypot(touch.clientX - press.clientX, touch.clientY - press.clientY) > mostOfTap)
        press = undefined;
    },
    touchcancel() {
      press = undefined;
    },
    touchend(event) {
      const touch = press;
      press = undefined;
      if (!touch || event.touches.length || !event.cancelable) return;
      event.preventDefault(); // else the press would arrive again, as a mouse's
      takeHold(canvas);
      for (const type of ["touchstart", "touchend"]) pass(type, touch);
    },
  };
  for (const type of Object.keys(follow)) {
    addEventListener(
      type,
      (event) => {
        if (event.target !== canvas) return;
        if (type === "touchstart" && event.touches.length === event.changedTouches.length) withheld = isGuest();
        if (!withheld) return;
        event.stopImmediatePropagation();
        follow[type](event);
      },
      { capture: true, passive: type !== "touchend" },
    );
  }
}

// SDL knows only when it received a press, and not the number of clicks in a row.
function connectPresses(program) {
  for (const type of ["mousedown", "touchstart"]) {
    addEventListener(type, (event) => program.press(event.timeStamp, event.detail), { capture: true, passive: true });
  }
}

// A finger that rests shows the tip that a mouse would show. A finger or a mouse that rests on a mark of the picture
// shows what it means.
function connectAsking(program) {
  const rest = 500; // milliseconds
  const options = { capture: true, passive: true };
  let timer, from;
  const end = () => clearTimeout(timer);
  addEventListener(
    "mousemove",
    ({ target, buttons }) => {
      end();
      if (target.id === "canvas" && !buttons) timer = setTimeout(() => program.call("page_ask"), rest);
    },
    options,
  );
  for (const type of ["mousedown", "mouseout"]) addEventListener(type, end, options);
  addEventListener(
    "touchstart",
    ({ touches }) => {
      end();
      if (touches.length !== 1 || touches[0].target.id !== "canvas") return;
      from = touches[0];
      timer = setTimeout(() => program.call("page_ask"), rest);
    },
    options,
  );
  addEventListener(
    "touchmove",
    ({ changedTouches: [to] }) =>
      from && Math.hypot(to.clientX - from.clientX, to.clientY - from.clientY) > mostOfTap && end(),
    options,
  );
  for (const type of ["touchend", "touchcancel"]) addEventListener(type, end, options);
}

function connectKeys(program, canvas, field, { embed }) {
  // At once, so that the field also receives the next key. A digit begins its number.
  const beginField = (key) => {
    if (/^[\d.,]$/.test(key)) field.begun = key;
    field.show();
  };
  // A button of the mirror uses only the keys of buttons.
  const ofButton = (event) =>
    event.target.matches?.("#mirror button") && !["Enter", " ", "Escape", "Tab"].includes(event.key);
  const ours = (event) =>
    !isGuest() &&
    (event.target === canvas || event.target === document.body || ofButton(event)) &&
    !document.querySelector("dialog:modal");
  addEventListener(
    "keydown",
    (event) => {
      if (!ours(event)) return;
      // SDL would hide every key from the browser, so none reaches SDL.
      event.stopImmediatePropagation();
      if (event.altKey || event.isComposing) return;
      const command = event.ctrlKey || event.metaKey;
      const endOfLesson = event.key === "Escape" && document.querySelector("#lesson-end .away");
      if (endOfLesson) {
        event.preventDefault();
        endOfLesson.click(); // the next Escape leaves the lesson
        return;
      }
      if (command && event.key.toLowerCase() === "c" && String(getSelection())) return;
      if (program.number("page_key", event.key, command ? 1 : 0, event.shiftKey ? 1 : 0)) {
        event.preventDefault();
        if (field.awaited) beginField(event.key);
      } else if (event.key === "Escape") {
        const beside = document.querySelector("dialog[open]"); // beside the canvas
        if (beside) beside.close();
        else if (embed) letGo();
      }
    },
    { capture: true },
  );
  for (const type of ["keyup", "keypress"]) {
    addEventListener(type, (event) => ours(event) && event.stopImmediatePropagation(), { capture: true });
  }
}
