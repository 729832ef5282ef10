// A walkthrough of the open polygon, the ready-made lessons, and one from a file.
import { buttonTo, fadeFoot, openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, icon } from "../kit/elements.js";
import { lowered, say, translated } from "../words/words.js";
import { show as showGlossary } from "./glossary.js";
import { show as showHandout } from "./handout.js";
import { show as showEditor } from "./lesson_editor.js";
import { openLessonText } from "./lesson_source.js";
import { openLesson, openLessonOf, seenLessons, watch } from "./lesson_watch.js";
import { underWay } from "../page/under_way.js";
import { fetchLessons } from "./ready_made.js";

export async function show(page) {
  const problem = problemLine();
  const list = el("section");
  const scroll = el(
    "div",
    { class: "scroll" },
    ofThisPolygon(page, () => root.close()),
    list,
  );
  const file = el("input", {
    type: "file",
    id: "lesson-file",
    class: "for-readers",
    tabindex: "-1",
    "aria-hidden": "true",
    accept: ".txt,text/plain",
  });
  file.addEventListener("change", async () => {
    const [chosen] = file.files;
    file.value = ""; // the same file may be chosen again
    if (!chosen) return;
    const why = await underWay(openFile(page, chosen));
    if (!why) return root?.close();
    problem.say(say("“{name}” cannot be opened: {why}", { name: chosen.name, why: lowered(why) }));
  });
  const root = await openWindow({
    name: "lessons",
    title: "Lessons",
    body: [
      scroll,
      problem,
      el(
        "footer",
        {},
        file,
        buttonTo("Glossary", page, showGlossary),
        buttonTo("Handout …", page, showHandout),
        buttonTo("Write a lesson …", page, showEditor),
        button("Open a lesson file …", { onclick: () => file.click() }, "file"),
      ),
    ],
  });
  if (!root) return;
  [scroll, root].forEach(fadeFoot); // on a small screen the whole window scrolls
  const choose = (lesson) => {
    const why = openLesson(page, lesson);
    if (why) problem.say(say("This lesson cannot be opened: {why}", { why: lowered(why) }));
    else root.close();
  };
  root.querySelector(".choice:enabled")?.focus();
  await load(page, list, choose);
  if (!root.contains(document.activeElement)) root.querySelector(".choice:enabled")?.focus();
}

async function openFile(page, file) {
  if (file.size > 65536) return "A lesson has at most 65,536 bytes";
  try {
    return await openLessonText(page, await file.text());
  } catch {
    return "It cannot be read";
  }
}

function choice(name, about, onclick, { mark, ...attributes } = {}) {
  return el(
    "button",
    { type: "button", class: "choice", onclick, ...attributes },
    el("span", {}, el("b", {}, name), " ", el("small", {}, about)),
    ...(mark ? [mark] : []),
  );
}

function ofThisPolygon(page, close) {
  const begin = (predict) => () => {
    page.nameLesson("");
    page.program.call("page_begin_walkthrough", predict);
    watch(page);
    close();
  };
  const refused = Boolean(page.program.text("page_refusal"));
  return el(
    "section",
    {},
    el("h3", {}, "This polygon"),
    refused ? el("p", { class: "second" }, "This polygon is refused. Correct it first.") : "",
    el(
      "div",
      { class: "choices lessons" },
      choice("Step by step", "How the algorithm places its robots", begin(0), { disabled: refused }),
      choice("As a challenge", "Predict each choice before you see it", begin(1), { disabled: refused }),
    ),
  );
}

async function load(page, list, choose) {
  list.replaceChildren(el("p", { class: "second", role: "status" }, "Loading …"));
  let lessons;
  try {
    lessons = await fetchLessons();
  } catch (error) {
    const line = problemLine();
    list.replaceChildren(line, button("Try again", { onclick: () => load(page, list, choose) }));
    line.say(say("The ready-made lessons cannot be fetched: {why}", { why: error.message }));
    return;
  }
  const seen = seenLessons();
  const open = openLessonOf(page.program)?.name;
  // The first unseen lesson after the last one seen, or else of all.
  const last = lessons.findIndex(({ name }) => name === [...seen].at(-1));
  const unseen = ({ name }, i) => !seen.has(name) && i > last;
  const later = lessons.findIndex(unseen);
  const next = later >= 0 ? later : lessons.findIndex(({ name }) => !seen.has(name));
  const about = (lesson, i) =>
    [
      say("about {minutes} min", { minutes: lesson.minutes }),
      lesson.name === open ? "open now" : seen.has(lesson.name) ? "seen" : seen.size > 0 && i === next ? "next" : "",
    ]
      .filter(Boolean)
      .map((words) => translated(words))
      .join(" · ");
  const entry = (lesson) => {
    const i = lessons.indexOf(lesson);
    return el(
      "li",
      {},
      choice(`${i + 1}. ${translated(lesson.title)}`, about(lesson, i), () => choose(lesson), {
        "data-name": lesson.name,
        "aria-current": lesson.name === open ? "true" : undefined,
        mark: seen.has(lesson.name) ? icon("check") : undefined,
      }),
    );
  };
  const total = (some) => some.reduce((sum, lesson) => sum + lesson.minutes, 0);
  const whole = {
    minutes: total(lessons),
    seen: lessons.filter(({ name }) => seen.has(name)).length,
    all: lessons.length,
  };
  const sessions = [...new Set(lessons.map(({ session }) => session))];
  list.replaceChildren(
    el(
      "h3",
      {},
      seen.size
        ? say("In order, about {minutes} minutes in total; {seen} of {all} seen", whole)
        : say("In order, about {minutes} minutes in total", whole),
    ),
    el(
      "p",
      {},
      el(
        "a",
        { href: new URL("docs-teaching.html", import.meta.url).href, target: "_blank", rel: "noopener" },
        "For teachers: the plan of three sessions, with sheets and homework",
      ),
    ),
    ...sessions.flatMap((session, number) => {
      const some = lessons.filter((lesson) => lesson.session === session);
      return [
        el(
          "h4",
          {},
          say("Session {number}: {session}, about {minutes} minutes", {
            number: number + 1,
            session,
            minutes: total(some),
          }),
        ),
        el("ol", { class: "choices lessons", start: String(lessons.indexOf(some[0]) + 1) }, ...some.map(entry)),
      ];
    }),
  );
}
