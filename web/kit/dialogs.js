// The frame of the page's windows. They are HTML, so that text can be typed and screen readers can read lists.
import { button, el } from "./elements.js";
import { translated } from "../words/words.js";

const styles = new Map();

// Resolves once a style sheet is loaded: the common one, or a window's own. They follow page.css, which is in the body,
// so that their rules come after its rules.
export function ensureStyles(name = "dialogs.css") {
  if (!styles.has(name)) {
    styles.set(
      name,
      new Promise((done) => {
        document.body.append(
          el("link", { rel: "stylesheet", href: new URL(name, import.meta.url).href, onload: done, onerror: done }),
        );
      }),
    );
  }
  return styles.get(name);
}

// Browsers report a closing a little late. By then the next window may have been requested, and the old one must not
// keep its name or focus.
async function windowsGone() {
  const leaving = [...document.querySelectorAll("dialog.window:not([open])")];
  await Promise.all(leaving.map((root) => new Promise((gone) => root.addEventListener("close", gone, { once: true }))));
}

// Opens a window: modal, or beside the canvas. After closing, the focus returns to the canvas, or, without a canvas or
// above another window, to its previous element. `tools` go into the header. Returns undefined if the window is open
// already, or if a modal window is open and `over` is false.
export async function openWindow({ name, title, modal = true, over = false, tools = [], body, focus, closed }) {
  await ensureStyles();
  await windowsGone();
  if (document.getElementById(name)?.open || (!over && document.querySelector("dialog:modal"))) return undefined;
  const before = document.activeElement;
  const close = button(
    "",
    { class: "button bare", "aria-label": "Close", title: "Close (Esc)", onclick: () => root.close() },
    "close",
  );
  const root = el(
    "dialog",
    { id: name, class: "window", "aria-labelledby": `${name}-title` },
    el("header", {}, el("h2", { id: `${name}-title` }, title), ...tools, close),
    ...body,
  );
  root.addEventListener("close", () => {
    closed?.();
    root.remove();
    const canvas = document.getElementById("canvas");
    const below = before?.isConnected && (before.closest("dialog") || canvas.hidden) ? before : canvas;
    below.focus({ preventScroll: true });
  });
  if (modal) closeOutside(root);
  document.body.append(root);
  if (modal) root.showModal();
  else root.show();
  (focus ?? close).focus();
  return root;
}

// Fades the content out at the bottom while there is more below: a cut line looks like a fault.
export function fadeFoot(scroller) {
  const shade = el("div", { class: "foot-shade", "aria-hidden": "true" });
  scroller.append(shade);
  const tell = () =>
    shade.classList.toggle("more", scroller.scrollHeight - scroller.scrollTop - scroller.clientHeight > 8);
  scroller.addEventListener("scroll", tell, { passive: true });
  const follow = new ResizeObserver(tell);
  for (const each of [scroller, ...scroller.children]) follow.observe(each);
}

export function closeWindows() {
  for (const root of document.querySelectorAll("dialog:modal")) root.close();
}

export function buttonTo(name, page, show) {
  return button(name, {
    onclick: ({ currentTarget }) => {
      currentTarget.closest("dialog").close();
      show(page);
    },
  });
}

// Pixels that a window covers at the left, the right and the bottom. A window that covers the whole screen hides the
// drawing, which then need not make room.
function covered(root) {
  const { left, right, top, height, width } = root.getBoundingClientRect();
  if (width >= innerWidth) return [0, 0, height >= innerHeight ? 0 : innerHeight - top];
  return left + right < innerWidth ? [right, 0, 0] : [0, innerWidth - left, 0];
}

// While a window is open, the drawing makes room for it. Returns a function that ends that.
export function makeRoom(program, root) {
  const tell = () => program.call("page_cover", ...covered(root));
  const follow = new ResizeObserver(tell);
  follow.observe(root);
  return () => {
    follow.disconnect();
    program.call("page_cover", 0, 0, 0);
  };
}

// A press and release beside the window closes it; selecting text beyond its edge does not.
function closeOutside(root) {
  let pressed = false;
  const outside = (event) => {
    const { left, right, top, bottom } = root.getBoundingClientRect();
    return (
      event.target === root &&
      (event.clientX < left || event.clientX > right || event.clientY < top || event.clientY > bottom)
    );
  };
  root.addEventListener("pointerdown", (event) => {
    pressed = outside(event);
  });
  root.addEventListener("click", (event) => pressed && outside(event) && root.close());
}

// Reports a problem, which is read out at once. At first it is empty and invisible.
export function problemLine(attributes = {}) {
  const line = el("p", { class: "problem", role: "alert", ...attributes });
  return Object.assign(line, {
    say(text) {
      line.textContent = text && `${translated(text).replace(/\.$/, "")}.`;
    },
  });
}
