// A lesson on paper: its steps as pictures with captions, six to a page, computed by a worker (wasm/modules/handout.cpp)
// and drawn by handout_picture.js.
import { casesTable } from "../kit/cases_table.js";
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, paragraphs, unbroken } from "../kit/elements.js";
import { qrCode } from "../kit/qr_code.js";
import { askOnce } from "../page/core.js";
import { say, translated } from "../words/words.js";
import { legend, picture } from "./handout_picture.js";
import { titleOf } from "./lesson_source.js";
import { openLessonOf } from "./lesson_watch.js";

// "5. Candidates (2 of 4)": each step has its own title, though a chapter may have several steps.
function titleOfStep({ steps }, step) {
  const ofChapter = steps.filter(({ chapter }) => chapter === step.chapter),
    parts = ofChapter.length,
    title = `${steps.indexOf(step) + 1}. ${translated(step.chapter)}`;
  return parts > 1 ? say("{title} ({part} of {parts})", { title, part: ofChapter.indexOf(step) + 1, parts }) : title;
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
      ...paragraphs(step.in_words),
      el("p", { class: step.in_words ? "own" : "" }, unbroken(step.caption)),
      step.formula ? el("p", { class: "formula" }, step.formula) : "",
    ),
  );
}

// The answer is upside down, so that it is not read by chance.
function questionOf({ question, answer }) {
  if (!question) return [];
  return [
    el(
      "section",
      { class: "paper-question" },
      el("h3", {}, "A question"),
      ...paragraphs(question),
      el("div", { class: "upside-down", role: "group", "aria-label": "The answer" }, ...paragraphs(answer)),
    ),
  ];
}

function casesOf({ cases }) {
  return cases ? [el("section", {}, el("h3", {}, "All cases of loading"), casesTable(cases))] : [];
}

// In words and as QR code, as far as it fits.
const longestPrinted = 300; // characters that a student might type, or compare
async function wayBack(address) {
  const code = await qrCode(address).catch(() => undefined);
  return [
    el(
      "p",
      { class: "paper-way" },
      code ? el("img", { alt: "QR code of the address", src: `data:image/svg+xml,${encodeURIComponent(code)}` }) : "",
      address.length <= longestPrinted ? el("span", {}, address) : "",
      code || address.length <= longestPrinted ? "" : el("span", {}, "The address is too long to be printed."),
    ),
  ];
}

function taskOf(program, { words, goals, may, numbered }) {
  const drawing = `data:image/svg+xml,${encodeURIComponent(program.text("page_svg"))}`;
  return [
    ...paragraphs(words),
    el("img", { class: "paper-task", alt: "The object and its robots", src: drawing }),
    el("ul", {}, ...goals.map((goal) => el("li", {}, goal.words))),
    el("p", {}, may),
    el(
      "p",
      {},
      numbered ? "Name: ______________________________   Number: ____________" : "Name: ______________________________",
    ),
  ];
}

// A title, a sentence about it, and a function that makes the elements.
function subjectOf(program, link) {
  const lesson = openLessonOf(program);
  const steps = async () => {
    const handout = await askOnce({ command: "handout", link, lesson: lesson?.text ?? "" });
    const figures = handout.steps.map((step) => figureOf(handout, step));
    return [...legend(handout), el("div", { class: "steps" }, ...figures), ...casesOf(handout), ...questionOf(handout)];
  };
  if (lesson) return { title: titleOf(lesson.text), about: "It shows the steps of the open lesson.", make: steps };
  const task = program.json("page_task");
  if (!task)
    return {
      title: "The algorithm step by step",
      about: "It shows the main steps for the open polygon. To print a lesson, open it first.",
      make: steps,
    };
  const question = program.text("page_lesson_question");
  const answer = program.text("page_lesson_answer");
  const make = async () => [...taskOf(program, task), ...questionOf({ question, answer })];
  return { title: task.title, about: "It shows the open task.", make };
}

export async function show(page) {
  const { program } = page;
  const link = program.text("page_link");
  const { title, about, make } = subjectOf(program, link);
  const problem = problemLine();
  const pages = el("div", { class: "pages" }, el("p", { class: "second", role: "status" }, "Drawing the pictures …"));
  const print = button("Print …", { class: "button primary", disabled: true, onclick: () => globalThis.print() });
  const root = await openWindow({
    name: "handout",
    title: "Handout",
    body: [
      el("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": "The handout" }, problem, pages),
      el("footer", {}, el("p", { class: "second" }, about), print),
    ],
  });
  if (!root) return;
  try {
    if (!link) throw new Error(say("this polygon has no link: {why}", { why: program.text("page_link_problem") }));
    pages.replaceChildren(
      el("h2", { class: "paper-title" }, title),
      ...(await make()),
      ...(await wayBack(page.address(link))),
      el("p", { class: "paper-foot" }, "Made with evenlift."),
    );
    print.disabled = false;
    print.focus();
  } catch (error) {
    pages.replaceChildren();
    problem.say(say("The handout cannot be made: {why}", { why: error.message }));
  }
}
