// The frame of the page's own windows. They are HTML, so that text can be typed and screen readers can read lists. Each
// window is a module of its own.
import { button, el } from "./elements.js";
import { translated } from "../words/words.js";

const styles = new Map();

// Resolves once a style sheet is loaded: the common one, or one that a single window needs.
export function ensureStyles(name = "dialogs.css") {
  if (!styles.has(name)) {
    styles.set(
      name,
      new Promise((done) => {
        document.head.append(
          el("link", { rel: "stylesheet", href: new URL(name, import.meta.url).href, onload: done, onerror: done }),
        );
      }),
    );
  }
  return styles.get(name);
}

// Resolves once every closed window is gone. Browsers report a closing a little late. By then the next window may have
// been requested, and the old one must not keep its name or focus.
async function windowsGone() {
  const leaving = [...document.querySelectorAll("dialog.window:not([open])")];
  await Promise.all(leaving.map((root) => new Promise((gone) => root.addEventListener("close", gone, { once: true }))));
}

// Opens a window: modal, or beside the canvas. Closing it removes its element and returns the focus to the canvas. If
// there is no canvas or another window is below, the focus returns to its previous element. `tools` are added to the
// header, and `focus` gets the focus. Returns the element; or undefined if the window is open already, or if a modal
// window is open and `over` is false.
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

// Fades the scrolled content of this element out at the bottom, as long as there is more below: a cut line looks like a
// fault.
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

// A button that closes its window and then opens another with `show`.
export function buttonTo(name, page, show) {
  return button(name, {
    onclick: ({ currentTarget }) => {
      currentTarget.closest("dialog").close();
      show(page);
    },
  });
}

// How far a window covers the screen at the left, at the right and at the bottom, in pixels. A window that covers all
// of it hides the drawing, which then need not make room.
function covered(root) {
  const { left, right, top, height, width } = root.getBoundingClientRect();
  if (width >= innerWidth) return [0, 0, height >= innerHeight ? 0 : innerHeight - top];
  return left + right < innerWidth ? [right, 0, 0] : [0, innerWidth - left, 0];
}

// The drawing makes room for a window beside or below it, as long as the window is open. Returns a function that ends
// that.
export function makeRoom(program, root) {
  const tell = () => program.call("page_cover", ...covered(root));
  const follow = new ResizeObserver(tell);
  follow.observe(root);
  return () => {
    follow.disconnect();
    program.call("page_cover", 0, 0, 0);
  };
}

// A press and release beside the window closes it. Selecting text beyond its edge does not.
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

// A line that reports a problem and is read out at once. It is empty and invisible at first.
export function problemLine(attributes = {}) {
  const line = el("p", { class: "problem", role: "alert", ...attributes });
  return Object.assign(line, {
    say(text) {
      line.textContent = text && `${translated(text).replace(/\.$/, "")}.`;
    },
  });
}
