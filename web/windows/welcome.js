// The card of the first visit.
import { closingButton, openCard } from "../kit/card.js";
import { el } from "../kit/elements.js";
import { lasting, write } from "../page/storage.js";
import { show as showSamples } from "./gallery.js";
import { show as showTour } from "./tour.js";

const welcomedKey = "evenlift.welcomed"; // page.js reads it

// Takes the focus, except at the first visit.
export async function show(page, { first = false } = {}) {
  const there = document.getElementById("welcome");
  if (there) return there.querySelector("button").focus({ preventScroll: true });
  const leave = new AbortController();
  const place = () => {
    page.program.number("page_key", "X", 0, 1);
    document.getElementById("canvas").focus({ preventScroll: true });
  };
  const draw = () => {
    page.program.number("page_key", "d", 0, 0);
    document.getElementById("canvas").focus({ preventScroll: true });
  };
  const card = await openCard(page, {
    name: "welcome",
    title: "How to begin",
    body: [
      el(
        "p",
        {},
        "Seen from above: where should robots stand to carry nearly the same load? ",
        el("span", { class: "second" }, "In teams of two, at the ends of a line through the centre of mass."),
      ),
      el(
        "div",
        { class: "ways" },
        closingButton("Place robots yourself", { class: "button primary" }, place),
        closingButton("Draw your own", {}, draw),
        closingButton("Choose a sample", {}, () => showSamples(page)),
        closingButton("Take the tour", { title: "It takes two minutes" }, () => showTour(page)),
      ),
    ],
    focus: !first,
    attributes: { class: "seat-card welcome" },
    closed: () => {
      leave.abort();
      write(lasting, welcomedKey, "1");
    },
  });
  if (first)
    page.announce(
      "How to begin: place robots yourself, draw your own shape, choose a sample, or take the tour. " +
        "Shift+W moves the focus there.",
    );
  // The first action closes the card. The program reports a change in the middle of it, so this waits for its end.
  const done = () => queueMicrotask(() => card.close());
  document.addEventListener("evenlift-change", done, { signal: leave.signal });
  page.pictures.addEventListener("drawn", () => page.program.number("page_is_drawing") && done(), {
    signal: leave.signal,
  });
}

export const welcome = (page) => show(page);
export const firstVisit = (page) => show(page, { first: true });
