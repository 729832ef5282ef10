// The two points and the line between them stay marked, however the view moves.
import { el, svgEl } from "../kit/elements.js";

const keys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const nearest = 8; // on the screen: a nearer press than this counts as the first point

// show() takes one point or two, in pixels of the picture.
function marksOver(page, { toScreen }) {
  const svg = svgEl("svg", { id: "measured", "aria-hidden": "true" });
  let points = [];
  const draw = () => {
    const [[x1, y1], [x2, y2] = []] = points.map(toScreen);
    // Twice: a broad light line below a dark one is visible on any picture.
    const lines = x2 === undefined ? [] : ["below", "above"].map((of) => svgEl("line", { x1, y1, x2, y2, class: of }));
    svg.replaceChildren(...lines, ...points.map(toScreen).map(([cx, cy]) => svgEl("circle", { cx, cy, r: 6 })));
  };
  const leave = new AbortController();
  page.pictures.addEventListener("drawn", () => points.length && draw(), { signal: leave.signal });
  document.getElementById("canvas").after(svg);
  return {
    show(those) {
      points = those;
      draw();
    },
    unmark() {
      leave.abort();
      svg.remove();
    },
  };
}

const distance = ([x1, y1], [x2, y2]) => Math.hypot(x1 - x2, y1 - y2);

// Waits for presses on two points, or for Enter after arrow keys moved a ring. `frame` converts from the screen to the
// picture's pixels and back: { fromScreen, toScreen, middle }. Returns { pixels, unmark }: the distance, and a function
// that removes the marks; undefined if Esc or an abort of `givenUp` ends the measurement.
export function twoPoints(page, frame, givenUp) {
  return new Promise((done) => {
    const marks = marksOver(page, frame);
    const sheet = el("div", {
      id: "measure",
      role: "application",
      "aria-label": "Two points of the picture",
      tabindex: "-1",
    });
    const leave = new AbortController();
    let first, ring; // in pixels of the picture; the ring that keys move is in pixels of the screen
    const end = (result) => {
      leave.abort();
      sheet.remove();
      if (!result) marks.unmark();
      done(result);
    };
    const aim = (at) => (first || ring) && marks.show([...(first ? [first] : []), frame.fromScreen(...at)]);
    const take = (at) => {
      const point = frame.fromScreen(...at);
      if (!first) {
        first = point;
        marks.show([first]);
        page.announce("The first point is taken.");
      } else if (distance(frame.toScreen(first), at) >= nearest) {
        marks.show([first, point]);
        end({ pixels: distance(first, point), unmark: marks.unmark });
      }
    };
    sheet.addEventListener("pointermove", ({ clientX, clientY }) => {
      ring = undefined;
      aim([clientX, clientY]);
    });
    sheet.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      take([event.clientX, event.clientY]);
    });
    sheet.addEventListener("keydown", (event) => {
      const way = keys[event.key];
      if (!way && !["Enter", " "].includes(event.key)) return;
      event.preventDefault();
      if (!way) return ring && take(ring);
      const far = event.shiftKey ? 1 : 10,
        [x, y] = ring ?? frame.middle();
      ring = [x + far * way[0], y + far * way[1]];
      aim(ring);
    });
    addEventListener(
      "keydown",
      (event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        event.stopImmediatePropagation();
        end();
      },
      { capture: true, signal: leave.signal },
    );
    givenUp.addEventListener("abort", () => end(), { signal: leave.signal });
    document.getElementById("canvas").after(sheet);
    sheet.focus({ preventScroll: true }); // the canvas would handle Esc itself
  });
}
