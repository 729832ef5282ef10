// The tour of the page: some stops of a sentence or two, each of which points at something. It changes nothing.
import { ensureStyles } from "../kit/dialogs.js";
import { button, el } from "../kit/elements.js";

const numbers = (text) => text.trim().split(" ").map(Number);

// Some of the vertices, if there are very many.
function corners(program) {
  const all = program.text("page_vertices", 0, program.number("page_vertex_count")).trimEnd().split("\n");
  const every = Math.ceil(all.length / 200);
  return all.filter((_, i) => i % every === 0).map(numbers);
}

// Where things are: boxes [left, top, right, bottom] in CSS pixels.
function places({ program }) {
  const screen = ([x, y]) => [program.number("page_screen_x", x, y), program.number("page_screen_y", x, y)];
  const bounds = (points, reach = 0) => [0, 1, 0, 1].map((axis, i) => {
    const all = points.map((point) => screen(point)[axis]);
    return i < 2 ? Math.min(...all) - reach : Math.max(...all) + reach;
  });
  const { metric, teams, centre_of_mass: centre } = JSON.parse(program.text("page_state"));
  return {
    around: bounds,
    balanced: metric === "balanced",
    team: teams[0]?.ends,
    centre,
    robots: teams.flatMap(({ ends }) => ends),
    vertex: numbers(program.text("page_vertices", 0, 1)),
    object: bounds(corners(program)),
    // The first of these controls that is shown; undefined if none is.
    control(...names) {
      const text = names.map((name) => program.text("page_control", name)).find(Boolean);
      if (!text) return undefined;
      const [x, y, width, height] = numbers(text);
      return [x - 4, y - 4, x + width + 4, y + height + 4];
    },
  };
}

// What a stop says, and the box that it points at, if that is there. A stop that points at nothing is left out, unless it is
// told `anyway`, in the middle of the window.
const stops = [
  {
    title: "Teams",
    words: "Two discs with the same number are one team. They stand at the two ends of a line through C, the centre of mass; such a line is called a chord.",
    box: (here) => !here.balanced && here.team && here.around(here.team, 20),
  }, {
    title: "Robots",
    words: "Each disc is a robot. The thin lines lead to C, the centre of mass, which is the centroid of all robots: so they balance the object.",
    box: (here) => here.balanced && here.team && here.around(here.robots, 20),
  }, {
    title: "Loads",
    words: "The number beside a disc is what this robot bears. C nearly halves its chord, so the two loads of a team are nearly equal.",
    box: (here) => !here.balanced && here.team && here.around([here.team[1]], 34),
  }, {
    title: "Loads",
    words: "The number beside a disc is what this robot bears. Balanced robots all bear exactly the same.",
    box: (here) => here.balanced && here.team && here.around([here.team[1]], 34),
  }, {
    title: "Lifting base",
    words: "The green area between the robots is the lifting base. A push down on the object inside it cannot tip the object; coverage says how much of the object that is.",
    box: (here) => (here.robots.length > 2 ? here.around(here.robots, 8) : undefined),
  }, {
    title: "Can it still move?",
    words: "Hatching shows the points about which the object could turn: clockwise in red, counter-clockwise in blue. Where there is none, the robots also keep the object from turning.",
    box: (here) => here.control("Clockwise", "Counter-clockwise") ?? (here.team && here.around([here.centre], 24)),
  }, {
    title: "Settings",
    words: "Choose how many teams there are, how they are chosen, and how even a chord must be at least. The answer follows at once.",
    box: (here) => here.control("teams +", "teams -", "robots +", "robots -"),
    anyway: true,
  }, {
    title: "The shape",
    words: matchMedia("(pointer: coarse)").matches
      ? "Drag a vertex, or C. A double tap on an edge adds a vertex; a vertex that you tap has a button that removes it. Undo takes all of it back."
      : "Drag a vertex, or C. A double click on an edge adds a vertex, and Delete removes the one that is selected; Undo takes all of it back.",
    box: (here) => here.around([here.vertex], 18),
  }, {
    title: "Lessons",
    words: "Lessons show the algorithm step by step, with the reason for each choice, also on a shape of your own.",
    box: (here) => here.control("Lessons"),
    anyway: true,
  }, {
    title: "Links",
    words: "The link in the address bar holds the shape and the settings. Send it, and others see what you see.",
    box: (here) => here.control("Copy link"),
    anyway: true,
  },
];

const between = (value, low, high) => Math.min(Math.max(value, low), high);

// The box as far as it is in the window.
function inWindow([left, top, right, bottom]) {
  return [between(left, 4, innerWidth - 4), between(top, 4, innerHeight - 4), between(right, 4, innerWidth - 4), between(bottom, 4, innerHeight - 4)];
}

// Where a bubble of this size stands, as [left, top]: in the window, and of the places beside the box that have room enough in
// the one that covers least of the object.
function besideBox([x0, y0, x1, y1], object, { width, height }) {
  const gap = 12, edge = 8;
  const [x, y] = [(x0 + x1 - width) / 2, (y0 + y1 - height) / 2];
  const inside = ([left, top]) => [between(left, edge, innerWidth - width - edge), between(top, edge, innerHeight - height - edge)];
  const covered = ([left, top]) => Math.max(0, Math.min(left + width, object[2]) - Math.max(left, object[0]))
    * Math.max(0, Math.min(top + height, object[3]) - Math.max(top, object[1]));
  const seats = [
    { room: innerWidth - x1 - width, at: [x1 + gap, y] }, { room: x0 - width, at: [x0 - gap - width, y] },
    { room: innerHeight - y1 - height, at: [x, y1 + gap] }, { room: y0 - height, at: [x, y0 - gap - height] },
  ];
  const free = seats.filter(({ room }) => room > gap).map(({ at }) => inside(at)).sort((a, b) => covered(a) - covered(b));
  return free[0] ?? inside([x, innerHeight - height - gap]);
}

export async function show(page) {
  await ensureStyles();
  if (document.getElementById("tour")) return;
  const here = places(page);
  const all = stops.filter(({ box, anyway }) => anyway || box(here));
  const ring = el("div", { class: "tour-ring", "aria-hidden": "true" });
  const heading = el("h2", { id: "tour-title" });
  const words = el("p", { id: "tour-words" });
  const count = el("span", { class: "second" });
  const back = button("Back", { onclick: () => go(-1) });
  const next = button("Next", { class: "button primary", onclick: () => go(1) });
  const skip = button("Skip", { class: "button bare", onclick: () => end() });
  const root = el("section", { id: "tour", role: "dialog", "aria-labelledby": "tour-title", "aria-describedby": "tour-words" },
    heading, words, el("div", { class: "row" }, count, skip, back, next));
  const leave = new AbortController();
  const { signal } = leave;
  let at = 0;

  function end() {
    leave.abort();
    root.remove();
    ring.remove();
    document.getElementById("canvas").focus({ preventScroll: true });
  }

  function go(by) {
    if (at + by >= all.length) return end();
    at = Math.max(at + by, 0);
    heading.textContent = all[at].title;
    words.textContent = all[at].words;
    count.textContent = `${at + 1} of ${all.length}`;
    back.disabled = at === 0;
    next.textContent = at + 1 === all.length ? "Done" : "Next";
    skip.hidden = at + 1 === all.length;
    place();
    next.focus({ preventScroll: true });
  }

  // The bubble stands beside what it points at, and never beyond the window.
  function place() {
    const now = places(page), box = all[at].box(now);
    ring.hidden = !box;
    const size = root.getBoundingClientRect();
    let [left, top] = [(innerWidth - size.width) / 2, (innerHeight - size.height) / 2];
    if (box) {
      const [x0, y0, x1, y1] = inWindow(box);
      Object.assign(ring.style, { left: `${x0}px`, top: `${y0}px`, width: `${Math.max(x1 - x0, 8)}px`, height: `${Math.max(y1 - y0, 8)}px` });
      [left, top] = besideBox([x0, y0, x1, y1], now.object, size);
    }
    root.style.left = `${Math.max(left, 0)}px`;
    root.style.top = `${Math.max(top, 0)}px`;
  }

  const later = () => requestAnimationFrame(() => requestAnimationFrame(() => !signal.aborted && place()));
  addEventListener("resize", later, { signal });
  document.addEventListener("evenlift-change", later, { signal });
  for (const type of ["pointerup", "wheel", "keyup"]) document.getElementById("canvas").addEventListener(type, later, { signal, passive: true });
  addEventListener("keydown", (event) => {
    const inside = root.contains(event.target);
    if (event.key === "Escape" && !document.querySelector("dialog:modal")) end();
    else if (inside && event.key === "ArrowRight") go(1);
    else if (inside && event.key === "ArrowLeft") go(-1);
    else return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }, { capture: true, signal });
  document.body.append(ring, root);
  go(0);
}
