// A lesson on paper: its steps as pictures with captions, six to a page. The steps come from a module of their
// own (wasm/modules/handout_api.cpp); handout_picture.js draws them.
import { coreModule } from "../kit/core_module.js";
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, unbroken } from "../kit/elements.js";
import { legend, picture } from "./handout_picture.js";
import { titleOf } from "./lesson_source.js";
import { openLessonOf } from "./lesson_watch.js";

const handoutModule = coreModule(() => import("./handout_core.js"));

// "x y x y …" as points.
function points(text) {
  const numbers = text ? text.split(" ").map(Number) : [];
  return Array.from({ length: numbers.length / 2 }, (_, i) => numbers.slice(2 * i, 2 * i + 2));
}

// The paragraphs of a teacher's words.
const paragraphs = (words) => (words ? unbroken(words).split("\v") : []);

function readStep([, chapter, caption, formula, words]) {
  return {
    chapter,
    caption: unbroken(caption),
    formula,
    inWords: paragraphs(words),
    base: [],
    candidates: [],
    teams: [],
    figures: [],
    robots: [],
    words: [],
  };
}

// The lines of handout_steps() as { width, height, disc, polygon, centre, steps, question, answer }.
function readHandout(text) {
  const handout = { steps: [] };
  for (const line of text.trimEnd().split("\n")) {
    const [what, ...parts] = line.split("\t");
    const step = handout.steps.at(-1);
    if (what === "problem") throw new Error(parts[0]);
    if (what === "paper") [handout.width, handout.height, handout.disc] = parts.map(Number);
    else if (what === "polygon" || what === "centre") handout[what] = points(parts[0]);
    else if (what === "question" || what === "answer") handout[what] = paragraphs(parts[0]);
    else if (what === "step") handout.steps.push(readStep(parts));
    else if (what === "base") step.base = points(parts[0]);
    else if (what === "candidate") step.candidates.push(points(parts[0]));
    else if (what === "team") step.teams.push(points(parts[0]));
    else if (what === "figure")
      step.figures.push({ kind: parts[0], number: parts[1], value: Number(parts[2]), points: points(parts[3]) });
    else if (what === "robot") step.robots.push({ number: parts[0], at: points(parts[1])[0] });
    else if (what === "words") step.words.push({ text: parts[0], at: points(parts[1])[0] });
  }
  return handout;
}

// "5. Candidates (2 of 4)": each step has a title of its own, though a chapter may have several.
function titleOfStep({ steps }, step) {
  const ofChapter = steps.filter(({ chapter }) => chapter === step.chapter),
    number = `${steps.indexOf(step) + 1}. ${step.chapter}`;
  return ofChapter.length > 1 ? `${number} (${ofChapter.indexOf(step) + 1} of ${ofChapter.length})` : number;
}

function figureOf(handout, step) {
  return el(
    "figure",
    {},
    picture(handout, step),
    el(
      "figcaption",
      {},
      el("b", {}, titleOfStep(handout, step)),
      ...step.inWords.map((words) => el("p", {}, words)),
      el("p", { class: step.inWords.length ? "own" : "" }, step.caption),
      step.formula ? el("p", { class: "formula" }, step.formula) : "",
    ),
  );
}

// The question at the lesson's end, and its answer upside down, so that nobody reads it by chance.
function questionOf({ question, answer }) {
  if (!question) return [];
  return [
    el(
      "section",
      { class: "paper-question" },
      el("h3", {}, "A question"),
      ...question.map((words) => el("p", {}, words)),
      el(
        "div",
        { class: "upside-down", role: "group", "aria-label": "The answer" },
        ...answer.map((words) => el("p", {}, words)),
      ),
    ),
  ];
}

export async function show(page) {
  const { program } = page;
  const lesson = openLessonOf(program);
  const link = program.text("page_link");
  const title = lesson ? titleOf(lesson.text) : "The algorithm step by step";
  const problem = problemLine();
  const pages = el(
    "div",
    { class: "pages" },
    el("p", { class: "second", role: "status" }, "The pictures are being drawn …"),
  );
  const print = button("Print …", { class: "button primary", disabled: true, onclick: () => globalThis.print() });
  const root = await openWindow({
    name: "handout",
    title: "Handout",
    body: [
      el("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": "The handout" }, problem, pages),
      el(
        "footer",
        {},
        el(
          "p",
          { class: "second" },
          lesson
            ? "It shows the steps of the lesson that is open."
            : "It shows the main steps for the polygon that is open. To print a lesson, open it first.",
        ),
        print,
      ),
    ],
  });
  if (!root) return;
  try {
    if (!link) throw new Error(`there is no link of this polygon: ${program.text("page_link_problem")}`);
    const handout = readHandout((await handoutModule()).text("handout_steps", link, lesson?.text ?? ""));
    const figures = handout.steps.map((step) => figureOf(handout, step));
    pages.replaceChildren(
      el("h2", { class: "paper-title" }, title),
      ...legend(handout),
      el("div", { class: "steps" }, ...figures),
      ...questionOf(handout),
      el("p", { class: "paper-foot" }, "Made with evenlift."),
    );
    print.disabled = false;
    print.focus();
  } catch (error) {
    pages.replaceChildren();
    problem.say(`The handout cannot be made: ${error.message}`);
  }
}
