// Tracks the open lesson, and shows the card at its end: the result of the guesses, a question, and the next lesson.
import { closingButton, openCard } from "../kit/card.js";
import { button, el, paragraphs } from "../kit/elements.js";
import { asTyped, say, translated } from "../words/words.js";
import { isLessonLink } from "../page/address.js";
import { lasting, read, write } from "../page/storage.js";
import { underWay } from "../page/under_way.js";
import { show as showTask } from "./task.js";
import { fetchLessons } from "./ready_made.js";

const seenKey = "evenlift.lessons";

// Ready-made lessons played to their end, in that order; a repeated one counts at its last time.
export function seenLessons() {
  return new Set(read(lasting, seenKey).split(" ").filter(Boolean));
}

function markSeen(name) {
  const seen = seenLessons();
  if (!name || isLessonLink(name)) return;
  seen.delete(name);
  write(lasting, seenKey, [...seen, name].join(" "));
}

let playing; // { page, lesson, atEnd, answered }; lesson: { name, title, text } as far as they are known

// Undefined if no lesson is open, or only the walkthrough of a polygon.
export function openLessonOf(program) {
  return playing?.lesson.text && program.number("page_script") === 2 ? playing.lesson : undefined;
}

// The state of a walkthrough (wasm/page/lesson_api.cpp), or null.
export const standing = (program) => program.json("page_lesson");

// Opens a lesson for the learner with this number, with the text of the polygon that it names; with `join` for the open
// document. Returns why it was refused, or undefined.
export function openLesson(page, { name, text, polygon = "" }, { join = false, number = 1 } = {}) {
  const problem = page.program.text("page_open_lesson", text, polygon, join ? 1 : 0, number);
  if (problem) return problem;
  page.nameLesson(name, number);
  const again = (another) => openLesson(page, { name, text, polygon }, { number: another });
  watch(page, { name, text, again });
  if (page.program.number("page_task_is_open") && !standing(page.program)) underWay(showTaskOf(page, playing));
  return undefined;
}

// Call this after opening a lesson or a challenge in another way.
export function watch(page, lesson = {}) {
  playing?.card?.close();
  // After the change, not in the middle of it.
  if (!playing) document.addEventListener("evenlift-change", () => queueMicrotask(look));
  // A document that is already open counts as looked at, so that a link to the last step does not congratulate.
  const now = standing(page.program);
  playing = { page, lesson, atEnd: Boolean(now && now.at + 1 === now.count) };
}

// After a lesson's steps, this card replaces the one at the end.
async function showTaskOf(page, of) {
  const { name, again } = of.lesson;
  of.card = await showTask(page, { again, done: () => markSeen(name) });
}

function look() {
  const { page, lesson } = playing;
  const now = standing(page.program);
  const script = page.program.number("page_script");
  // Editing the polygon at the end means trying out the question, so the card stays.
  const ours = now && (lesson.text ? script === 2 || (script === 1 && playing.atEnd) : script === 0);
  const atEnd = Boolean(ours && now.at + 1 === now.count);
  if (atEnd === playing.atEnd) return;
  playing.atEnd = atEnd;
  if (!atEnd) return playing.card?.close();
  if (page.program.number("page_task_is_open")) {
    underWay(showTaskOf(page, playing));
    return;
  }
  markSeen(lesson.name);
  underWay(showEnd(page, lesson, now, playing));
}

// Once shown, the answer appears at every return to the end.
function questionOf(program, of) {
  const answer = el("div", { role: "status" });
  const told = (attributes) => paragraphs(program.text("page_lesson_answer"), { class: "second", ...attributes });
  const show = () => answer.replaceChildren(...told());
  const byKeys = el(
    "p",
    { class: "second by-keys" },
    JSON.parse(program.text("page_state")).metric === "balanced"
      ? "Try it here: T and Shift+T change the number of robots, and you can drag C."
      : "Try it here: T and Shift+T change the number of teams, and you can drag C.",
  );
  const words = [...paragraphs(program.text("page_lesson_question"), { class: "question" }), byKeys, answer];
  if (of.answered) {
    show();
    return { words };
  }
  // Space is reserved, so that the drawing does not move when the answer appears.
  answer.replaceChildren(el("div", { class: "waits", "aria-hidden": "true" }, ...told()));
  const shown = button("Answer", {
    class: "button unfolded",
    onclick: () => {
      of.answered = true;
      show();
      answer.parentElement.classList.add("answered");
      const next = shown.nextElementSibling;
      const byKey = shown.matches(":focus-visible");
      shown.remove();
      if (byKey) next.focus();
      of.card.seat();
    },
  });
  return { words, button: shown };
}

// A small screen begins with a row of buttons, so that the shape in the question keeps its room.
function foldButton(of) {
  const fold = button("Question", {
    "aria-expanded": "false",
    onclick: () => {
      const folded = of.card.root.classList.toggle("folded");
      fold.setAttribute("aria-expanded", String(!folded));
      fold.textContent = translated(folded ? "Question" : "Fold");
      of.card.seat();
    },
  });
  return fold;
}

function toNext({ title }, act) {
  const go = closingButton("", { class: "button primary", title }, act);
  go.append(
    el("span", { class: "whole" }, say("Next: {title}", { title: asTyped(title) })),
    el("span", { class: "short" }, "Next lesson"),
  );
  return go;
}

function scoreOf({ guesses, right, told, passed }) {
  if (!guesses) return { score: "", further: [] };
  return {
    score:
      guesses === 1
        ? say("{right} of 1 guess was right.", { right })
        : say("{right} of {guesses} guesses were right.", { right, guesses }),
    further: [
      passed === 1
        ? translated("One question was skipped.")
        : passed && say("{passed} questions were skipped.", { passed }),
      told === 1
        ? translated("One more choice was shown without a question: each kind is asked at most three times.")
        : told &&
          say("{told} more choices were shown without a question: each kind is asked at most three times.", { told }),
    ].filter(Boolean),
  };
}

async function showEnd(page, lesson, now, of) {
  const all = lesson.name ? await fetchLessons().catch(() => []) : [];
  const index = all.findIndex(({ name }) => name === lesson.name);
  const next = index >= 0 ? all[index + 1] : undefined;
  const { score, further } = scoreOf(now);
  const asked = page.program.text("page_lesson_question");
  if (!score && index < 0 && !asked) return;
  if (playing !== of || !of.atEnd || document.querySelector("dialog[open]:not(#editor)")) return;
  const ended =
    index >= 0
      ? say("The end of lesson {number} of {all}.", { number: index + 1, all: all.length })
      : translated("This is the end.");
  const seen = seenLessons();
  const question = asked ? questionOf(page.program, of) : undefined;
  const toFold = asked && matchMedia("(max-height: 600px)").matches ? foldButton(of) : "";
  if (index >= 0 && all.every(({ name }) => seen.has(name))) further.push(translated("You have seen all lessons."));
  of.card = await openCard(page, {
    name: "lesson-end",
    title: "The end of the lesson",
    attributes: toFold ? { class: "seat-card folded" } : {},
    body: [
      el(
        "div",
        { class: of.answered ? "said answered" : "said" },
        el("p", { role: "status" }, `${ended} `, score ? el("b", {}, score) : "", ...further.map((each) => ` ${each}`)),
        ...(question?.words ?? []),
      ),
      el(
        "div",
        { class: "ways" },
        toFold,
        question?.button ?? "",
        next ? toNext(next, () => openLesson(page, next)) : "",
        closingButton("All lessons", { class: "button seldom" }, () =>
          page.windows().then((windows) => windows.lessons(page)),
        ),
      ),
    ],
  });
}
