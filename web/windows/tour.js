// The tour's card is at the bottom of the drawing, so that it covers nothing that it describes. The tour changes
// nothing.
import { openCard } from "../kit/card.js";
import { button, el, svgEl } from "../kit/elements.js";
import { say, translated } from "../words/words.js";
import { look, reveal } from "./tour_places.js";
import { stops } from "./tour_stops.js";

function drawn({ circle, box, line }) {
  if (circle) return svgEl("circle", { cx: circle[0], cy: circle[1], r: circle[2] });
  if (box) return svgEl("rect", { x: box[0], y: box[1], width: box[2], height: box[3], rx: 10 });
  const [[x1, y1], [x2, y2]] = line;
  return svgEl("line", { x1, y1, x2, y2 });
}

function ringed(here, { points, controls, menu }) {
  const shapes = points?.(here);
  if (shapes) return shapes;
  const shown = here.controls(...controls);
  return shown.length ? shown : menu ? here.controls("more") : here.sheet();
}

// The hidden texts of other stops keep the card's height, so that neither its buttons nor the drawing move.
const unseen = (all, here) =>
  all.map(({ title, words }) =>
    el("div", { class: "unseen", "aria-hidden": "true" }, el("h2", {}, title), " ", el("p", {}, words(here))),
  );

export async function show(page) {
  if (document.getElementById("tour")) return;
  const first = look(page);
  const all = stops.filter(({ where }) => !where || where(first));
  const rings = svgEl("svg", { class: "tour-rings", "aria-hidden": "true" });
  const heading = el("h2", { id: "tour-title" });
  const words = el("p", { id: "tour-words" });
  const count = el("span", { class: "second" });
  const back = button("Back", { onclick: () => go(-1) });
  const next = button("Next", { class: "button primary", onclick: () => go(1) });
  const skip = button("Skip", { class: "button bare", onclick: () => card.close() });
  const leave = new AbortController();
  const { signal } = leave;
  let at = 0;

  function go(by) {
    if (at + by >= all.length) return card.close();
    at = Math.max(at + by, 0);
    heading.textContent = translated(all[at].title);
    count.textContent = say("{number} of {all}", { number: at + 1, all: all.length });
    back.disabled = at === 0;
    next.textContent = translated(at + 1 === all.length ? "Done" : "Next");
    skip.classList.toggle("unseen", at + 1 === all.length);
    reveal(page, all[at]);
    place();
    next.focus({ preventScroll: true });
  }

  // While a stop is shown, the drawing may move and the placement may change.
  function place() {
    const here = look(page);
    const { where, words: wordsOf } = all[at];
    const said = translated(wordsOf(here));
    if (words.textContent !== said) words.textContent = said;
    rings.replaceChildren(...(!where || where(here) ? ringed(here, all[at]).map(drawn) : []));
  }

  const card = await openCard(page, {
    name: "tour",
    title: "Tour",
    cross: false,
    attributes: { role: "dialog", "aria-labelledby": "tour-title", "aria-describedby": "tour-words" },
    body: [
      el("div", { class: "stops", "aria-live": "polite" }, el("div", {}, heading, " ", words), ...unseen(all, first)),
      el("div", { class: "ways" }, count, skip, back, next),
    ],
    closed: () => {
      leave.abort();
      rings.remove();
      document.getElementById("canvas").focus({ preventScroll: true });
    },
  });
  document.body.append(rings);
  page.pictures.addEventListener("drawn", place, { signal });
  addEventListener(
    "keydown",
    (event) => {
      const inside = card.root.contains(event.target);
      if (event.key === "Escape" && !document.querySelector("dialog:modal")) card.close();
      else if (inside && event.key === "ArrowRight") go(1);
      else if (inside && event.key === "ArrowLeft") go(-1);
      else return;
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    { capture: true, signal },
  );
  go(0);
}
