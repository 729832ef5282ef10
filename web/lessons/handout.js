// A lesson on paper: its steps as pictures with captions, six to a page. A separate module computes the steps
// (wasm/modules/handout_api.cpp); handout_picture.js draws them.
import { coreModule } from "../kit/core_module.js";
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, unbroken } from "../kit/elements.js";
import { qrCode } from "../kit/qr_code.js";
import { legend, picture } from "./handout_picture.js";
import { titleOf } from "./lesson_source.js";
import { openLessonOf } from "./lesson_watch.js";

const handoutModule = coreModule(() => import("./handout_core.js"));

// The paragraphs of a teacher's words.
const paragraphs = (words) => (words ? unbroken(words).split("\n") : []);

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
      ...paragraphs(step.in_words).map((words) => el("p", {}, words)),
      el("p", { class: step.in_words ? "own" : "" }, unbroken(step.caption)),
      step.formula ? el("p", { class: "formula" }, step.formula) : "",
    ),
  );
}

// The question at the lesson's end. Its answer is upside down, so that it is not read by chance.
function questionOf({ question, answer }) {
  if (!question) return [];
  return [
    el(
      "section",
      { class: "paper-question" },
      el("h3", {}, "A question"),
      ...paragraphs(question).map((words) => el("p", {}, words)),
      el(
        "div",
        { class: "upside-down", role: "group", "aria-label": "The answer" },
        ...paragraphs(answer).map((words) => el("p", {}, words)),
      ),
    ),
  ];
}

// The address that opens the same, in words and as a QR code, as far as it fits.
const longestPrinted = 300; // characters that a student might type, or at least compare
async function wayBack(address) {
  if (!address) return [];
  const code = await qrCode(address).catch(() => undefined);
  return [
    el(
      "p",
      { class: "paper-way" },
      code ? el("img", { alt: "QR code of the address", src: `data:image/svg+xml,${encodeURIComponent(code)}` }) : "",
      address.length <= longestPrinted ? el("span", {}, address) : "",
    ),
  ];
}

// A task on paper: its object, what is to be reached, and a place for the learner's name and number.
function taskOf(program, { words, goals, may, numbered }) {
  const drawing = `data:image/svg+xml,${encodeURIComponent(program.text("page_svg"))}`;
  return [
    ...paragraphs(words).map((each) => el("p", {}, each)),
    el("img", { class: "paper-task", alt: "The object and its robots", src: drawing }),
    el("ul", {}, ...goals.map((goal) => el("li", {}, goal.words))),
    el("p", {}, may),
    el("p", {}, `Name: ______________________________${numbered ? "   Number: ____________" : ""}`),
  ];
}

export async function show(page) {
  const { program } = page;
  const lesson = openLessonOf(program);
  const task = lesson ? null : program.json("page_task");
  const link = program.text("page_link");
  const title = lesson ? titleOf(lesson.text) : task ? task.title : "The algorithm step by step";
  const problem = problemLine();
  const pages = el("div", { class: "pages" }, el("p", { class: "second", role: "status" }, "Drawing the pictures …"));
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
          task
            ? "It shows the open task."
            : lesson
              ? "It shows the steps of the open lesson."
              : "It shows the main steps for the open polygon. To print a lesson, open it first.",
        ),
        print,
      ),
    ],
  });
  if (!root) return;
  try {
    if (!link) throw new Error(`this polygon has no link: ${program.text("page_link_problem")}`);
    if (task) {
      const { question, answer } = {
        question: program.text("page_lesson_question"),
        answer: program.text("page_lesson_answer"),
      };
      pages.replaceChildren(
        el("h2", { class: "paper-title" }, title),
        ...taskOf(program, task),
        ...questionOf({ question, answer }),
        ...(await wayBack(page.address(link))),
        el("p", { class: "paper-foot" }, "Made with evenlift."),
      );
      print.disabled = false;
      return print.focus();
    }
    const handout = (await handoutModule()).json("handout_steps", link, lesson?.text ?? "");
    if (handout.problem) throw new Error(handout.problem);
    const figures = handout.steps.map((step) => figureOf(handout, step));
    pages.replaceChildren(
      el("h2", { class: "paper-title" }, title),
      ...legend(handout),
      el("div", { class: "steps" }, ...figures),
      ...questionOf(handout),
      ...(await wayBack(page.address(link))),
      el("p", { class: "paper-foot" }, "Made with evenlift."),
    );
    print.disabled = false;
    print.focus();
  } catch (error) {
    pages.replaceChildren();
    problem.say(`The handout cannot be made: ${error.message}`);
  }
}
