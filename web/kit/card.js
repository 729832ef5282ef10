// HTML cards at the bottom of the drawing. They are not modal, so work can continue. The program reports where a card
// covers no control, and the polygon gets the remaining space.
import { ensureStyles } from "./dialogs.js";
import { button, el, icon } from "./elements.js";
import { translated } from "../words/words.js";

const widest = 960; // pixels: longer lines are hard to read
let open; // at most one
const later = []; // actions

export function whenNoCard(act) {
  if (open) later.push(act);
  else act();
}

// Closes its card, then acts. Attributes are as for el().
export function closingButton(name, attributes, act) {
  return button(name, {
    ...attributes,
    onclick: () => {
      open.close();
      act();
    },
  });
}

// Shows a card with these elements in place of any open card. `title` is its name for screen readers; `attributes` are
// as for el(). A cross closes it, unless one of its own buttons does (`cross`). Then `closed(byPerson)` is called. A card
// that `folds` has a fold in place of the cross: it then shows only what has the class "brief".
// Returns { root, close, seat }; call seat() when the card's height has changed. If the program moves the seat, the
// card follows; in presentation mode it is larger.
export async function openCard(
  page,
  { name, title, body, closed, focus = false, cross = true, folds, attributes = {} },
) {
  await ensureStyles();
  open?.close();
  const root = el(
    "section",
    { id: name, class: "seat-card", role: "region", "aria-label": title, ...attributes },
    ...body,
    ...(folds ? [button("", { class: "button bare away", onclick: () => fold() })] : []),
    ...(cross && !folds
      ? [
          button(
            "",
            { class: "button bare away", "aria-label": "Close", title: "Close", onclick: () => close(true) },
            "close",
          ),
        ]
      : []),
  );
  const leave = new AbortController();
  const canvas = document.getElementById("canvas");
  function close(byPerson = false) {
    if (leave.signal.aborted) return;
    leave.abort();
    open = undefined;
    queueMicrotask(() => open || later.shift()?.()); // not if another card takes its place
    const within = root.contains(document.activeElement);
    root.remove();
    page.program.call("page_make_room", 0);
    if (within) canvas.focus({ preventScroll: true });
    closed?.(byPerson);
  }
  const foldButton = () => root.querySelector(".away");
  function tellFold() {
    const folded = root.classList.contains("folded");
    const name = folded ? "Unfold" : "Fold";
    foldButton().setAttribute("aria-expanded", String(!folded));
    foldButton().setAttribute("aria-label", translated(name));
    foldButton().title = translated(name);
    foldButton().replaceChildren(icon(folded ? "unfolds" : "folds"));
  }
  function fold() {
    const within = root.contains(document.activeElement);
    root.classList.toggle("folded");
    tellFold();
    if (within) foldButton().focus({ preventScroll: true }); // what had it may be hidden now
    seat();
  }
  if (folds) tellFold();
  const place = () =>
    `[${page.program.text("page_card_seat")},${page.program.number("page_zoom")},${page.program.number("page_presenting")}]`;
  let placed;
  const seat = () => {
    if (leave.signal.aborted) return;
    placed = place();
    const [at, zoom, presenting] = JSON.parse(placed);
    const bottom = at.top + at.height;
    const width = Math.min(at.width / zoom, widest);
    root.style.scale = zoom;
    root.style.left = `${at.left + (at.width - width * zoom) / 2}px`;
    root.style.width = `${width}px`;
    root.style.maxHeight = `${at.height / zoom}px`;
    root.classList.toggle("in-a-row", width >= 600);
    root.classList.toggle("before-a-room", presenting === 1);
    const height = root.offsetHeight * zoom;
    root.style.top = `${bottom - height}px`;
    page.program.call("page_make_room", height);
  };
  canvas.after(root); // next to be reached by Tab
  seat();
  const { signal } = leave;
  // The loaded font needs a different amount of space.
  const follow = new ResizeObserver(seat);
  follow.observe(root);
  signal.addEventListener("abort", () => follow.disconnect());
  // A list that the panels draw on the canvas, below the card, must stay visible.
  const giveWay = () => {
    const list = page.program.json("page_open_list");
    const card = root.getBoundingClientRect();
    const covers =
      list &&
      list.top + list.height > card.top &&
      list.top < card.bottom &&
      list.left + list.width > card.left &&
      list.left < card.right;
    root.classList.toggle("gives-way", Boolean(covers));
  };
  page.pictures.addEventListener(
    "drawn",
    () => {
      if (place() !== placed) seat();
      giveWay();
    },
    { signal },
  );
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    event.preventDefault();
    if (folds) fold();
    else close(true);
  });
  if (focus) root.querySelector("button").focus({ preventScroll: true });
  open = { root, close, seat };
  return open;
}
