// A lesson on paper: its steps as pictures with captions, six to a page. The steps come from a module of their
// own (wasm/modules/handout_api.cpp); here they are drawn.
import { coreModule } from "../kit/core_module.js";
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, svgEl } from "../kit/elements.js";
import { fitted } from "../kit/fit.js";
import { titleOf } from "./lesson_source.js";
import { openLessonOf } from "./lesson_watch.js";

const handoutModule = coreModule(() => import("./handout_core.js"));

// "x y x y …" as points.
function points(text) {
  const numbers = text ? text.split(" ").map(Number) : [];
  return Array.from({ length: numbers.length / 2 }, (_, i) => numbers.slice(2 * i, 2 * i + 2));
}

// The paragraphs of a teacher's words.
const paragraphs = (words) => words ? words.split("\v") : [];

function readStep([, chapter, caption, formula, words]) {
  return { chapter, caption, formula, words: paragraphs(words), base: [], candidates: [], teams: [], figures: [] };
}

// The lines of handout_steps() as { polygon, centre, steps, question, answer }.
function readHandout(text) {
  const handout = { steps: [] };
  for (const line of text.trimEnd().split("\n")) {
    const [what, ...parts] = line.split("\t");
    const step = handout.steps.at(-1);
    if (what === "problem") throw new Error(parts[0]);
    if (what === "polygon" || what === "centre") handout[what] = points(parts[0]);
    else if (what === "question" || what === "answer") handout[what] = paragraphs(parts[0]);
    else if (what === "step") handout.steps.push(readStep(parts));
    else if (what === "base") step.base = points(parts[0]);
    else if (what === "candidate") step.candidates.push(points(parts[0]));
    else if (what === "team") step.teams.push({ ends: points(parts[0]), loads: parts.slice(1) });
    else if (what === "figure") step.figures.push({ kind: parts[0], item: parts[1] && Number(parts[1]), value: Number(parts[2]), points: points(parts[3]) });
  }
  return handout;
}

const width = 320;
const height = 220;
const margin = 30;

// The look of each kind of figure, a class of dialogs.css; a kind that is not listed is drawn as an accent.
const looks = {
  base: "base", base_before: "base-before", clockwise: "clockwise", counterclockwise: "counterclockwise",
  candidate: "candidate", team: "chord", edge: "edge", section: "section", normal: "normal",
  gain_triangle: "gain", gain_part: "gain", arm_before: "thin", arm_after: "thin", triangle: "thin",
  unusable: "normal", body: "thin", hand: "thin",
};

// An area, a line or a dot, whichever these points make.
function shape(points, look, place) {
  const placed = points.map(place);
  if (placed.length > 2) return svgEl("polygon", { points: placed.map((point) => point.join(" ")).join(" "), class: look });
  const [[x1, y1], [x2, y2] = []] = placed;
  if (placed.length < 2) return svgEl("circle", { cx: x1, cy: y1, r: 4, class: look });
  return svgEl("line", { x1, y1, x2, y2, class: look });
}

function drawnFigure({ kind, points, value }, place) {
  if (kind !== "gain_circle" && kind !== "body") return shape(points, looks[kind] ?? "accent", place);
  const [[x, y]] = points;
  const [cx, cy] = place([x, y]), [rim] = place([x + value, y]);
  return svgEl("circle", { cx, cy, r: Math.abs(rim - cx), class: looks[kind] ?? "gain" });
}

// A robot with the number of its team, and what it bears on the side that is away from the centre of mass.
function robot(team, end, load, [cx, cy], place) {
  const [x, y] = place(end), away = Math.hypot(x - cx, y - cy) || 1;
  const parts = [svgEl("circle", { cx: x, cy: y, r: 8, class: "robot" }), svgEl("text", { x, y: y + 3.5, class: "team-number" }, String(team + 1))];
  if (load === undefined) return parts;
  const at = { x: x + (x - cx) / away * 18, y: y + (y - cy) / away * 15 + 3.5 };
  return [...parts, svgEl("text", { ...at, class: "load" }, load)];
}

// Twice the area of a polygon, negative if it runs clockwise.
const turn = (polygon) => polygon.reduce((sum, [x, y], i) => {
  const [u, v] = polygon[(i + 1) % polygon.length];
  return sum + x * v - u * y;
}, 0);

// The name of an edge or a vertex that the step is about, on the outer side of it.
function partName({ polygon, centre }, { kind, item, points }, place) {
  if (item === "" || !["edge", "vertex"].includes(kind)) return [];
  const [from, to] = kind === "edge" ? points : [centre[0], points[0]];
  const [x, y] = kind === "edge" ? [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2] : points[0];
  const side = kind === "edge" ? Math.sign(turn(polygon)) : 1;
  const [u, v] = kind === "edge" ? [side * (to[1] - from[1]), side * (from[0] - to[0])] : [to[0] - from[0], to[1] - from[1]];
  const name = `${kind} ${item + 1}`, beside = 10 + 2.8 * name.length;  // half of its width, and a little
  const long = Math.hypot(u, v) || 1, [px, py] = place([x, y]);
  return [svgEl("text", { x: px + u / long * beside, y: py - v / long * 13 + 3.5, class: "load" }, name)];
}

// A picture of a step. `place` maps polygon coordinates to the paper.
function picture({ polygon, centre }, step, place) {
  const [cx, cy] = place(centre[0]);
  const parts = [
    svgEl("polygon", { points: polygon.map(place).map((point) => point.join(" ")).join(" "), class: "object" }),
    ...(step.base.length > 1 ? [shape(step.base, "base", place)] : []),
    ...step.candidates.map((chord) => shape(chord, "candidate", place)),
    ...step.teams.map(({ ends }) => shape(ends, "chord", place)),
    ...step.figures.filter(({ kind, points }) => points.length && kind !== "robot").map((figure) => drawnFigure(figure, place)),
    ...step.teams.flatMap(({ ends, loads }, team) => ends.flatMap((end, i) => robot(team, end, loads[i], [cx, cy], place))),
    svgEl("circle", { cx, cy, r: 3.5, class: "centre" }),
    svgEl("text", { x: cx + 9, y: cy - 6, class: "load" }, "C"),
    ...step.figures.flatMap((figure) => partName({ polygon, centre }, figure, place)),
  ];
  // Lines and regions that go on beyond the paper are cut off by it.
  return svgEl("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": step.caption, class: "paper" }, ...parts);
}

function figureOf(handout, step, number, place) {
  return el("figure", {}, picture(handout, step, place), el("figcaption", {},
    el("b", {}, `${number}. ${step.chapter}`), ...step.words.map((words) => el("p", {}, words)),
    el("p", { class: step.words.length ? "own" : "" }, step.caption),
    step.formula ? el("p", { class: "formula" }, step.formula) : ""));
}

// The question at the lesson's end, and its answer upside down, so that nobody reads it by chance.
function questionOf({ question, answer }) {
  if (!question) return [];
  return [el("section", { class: "paper-question" }, el("h3", {}, "A question"), ...question.map((words) => el("p", {}, words)),
    el("div", { class: "upside-down", role: "group", "aria-label": "The answer" }, ...answer.map((words) => el("p", {}, words))))];
}

export async function show(page) {
  const { program } = page;
  const lesson = openLessonOf(program);
  const link = program.text("page_link");
  const title = lesson ? titleOf(lesson.text) : "The algorithm step by step";
  const problem = problemLine();
  const pages = el("div", { class: "pages" }, el("p", { class: "second", role: "status" }, "The pictures are being drawn …"));
  const print = button("Print …", { class: "button primary", disabled: true, onclick: () => globalThis.print() });
  const root = await openWindow({
    name: "handout",
    title: "Handout",
    body: [el("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": "The handout" }, problem, pages), el("footer", {},
      el("p", { class: "second" }, lesson ? "It shows the steps of the lesson that is open."
        : "It shows the main steps for the polygon that is open. To print a lesson, open it first."), print)],
  });
  if (!root) return;
  try {
    if (!link) throw new Error(`there is no link of this polygon: ${program.text("page_link_problem")}`);
    const handout = readHandout((await handoutModule()).text("handout_steps", link, lesson?.text ?? ""));
    const place = fitted(handout.polygon, width, height, margin);
    const figures = handout.steps.map((step, i) => figureOf(handout, step, i + 1, place));
    pages.replaceChildren(el("h2", { class: "paper-title" }, title), el("div", { class: "steps" }, ...figures), ...questionOf(handout), el("p", { class: "paper-foot" }, "Made with evenlift."));
    print.disabled = false;
    print.focus();
  } catch (error) {
    pages.replaceChildren();
    problem.say(`The handout cannot be made: ${error.message}`);
  }
}
