// The window of lessons: a walkthrough of the polygon that is open, the ready-made lessons, and one from a file.
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, lowered } from "../kit/elements.js";
import { fetchJson } from "../kit/fetched.js";
import { openLessonText, openReadyMade } from "./lesson_source.js";
import { underWay } from "../page/under_way.js";

export async function show(page) {
  const problem = problemLine();
  const list = el("section");
  const file = el("input", { type: "file", id: "lesson-file", class: "for-readers", tabindex: "-1", "aria-hidden": "true", accept: ".txt,text/plain" });
  file.addEventListener("change", async () => {
    const [chosen] = file.files;
    file.value = "";  // the same file may be chosen again
    if (!chosen) return;
    const why = await underWay(openFile(page, chosen));
    if (why) problem.say(`“${chosen.name}” cannot be opened: ${lowered(why)}`);
    else root?.close();
  });
  const root = await openWindow({
    name: "lessons",
    title: "Lessons",
    body: [el("div", { class: "scroll" }, ofThisPolygon(page, () => root.close()), list), problem,
      el("footer", {}, file, button("Open a lesson file …", { onclick: () => file.click() }, "file"))],
  });
  if (!root) return;
  const choose = (lesson) => {
    const why = openReadyMade(page, lesson);
    if (why) problem.say(`This lesson cannot be opened: ${lowered(why)}`);
    else root.close();
  };
  root.querySelector(".choice:enabled")?.focus();
  await load(list, choose);
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

function choice(name, about, onclick, attributes = {}) {
  return el("button", { type: "button", class: "choice", onclick, ...attributes }, el("span", {}, el("b", {}, name), " ", el("small", {}, about)));
}

function ofThisPolygon(page, close) {
  const begin = (predict) => () => {
    page.nameLesson("");
    page.program.call("page_begin_walkthrough", predict);
    close();
  };
  const refused = Boolean(page.program.text("page_refusal"));
  return el("section", {}, el("h3", {}, "This polygon"),
    refused ? el("p", { class: "second" }, "This polygon is refused. Correct it first.") : "",
    el("div", { class: "choices lessons" },
      choice("Step by step", "All that the algorithm does with it", begin(0), { disabled: refused }),
      choice("As a challenge", "Predict each choice before you see it", begin(1), { disabled: refused })));
}

async function load(list, choose) {
  list.replaceChildren(el("p", { class: "second", role: "status" }, "Loading …"));
  let lessons;
  try {
    lessons = await fetchJson("lessons.json");
  } catch (error) {
    const line = problemLine();
    list.replaceChildren(line, button("Try again", { onclick: () => load(list, choose) }));
    line.say(`The ready-made lessons cannot be fetched: ${error.message}`);
    return;
  }
  list.replaceChildren(el("h3", {}, "Ready-made"), el("ol", { class: "choices lessons" },
    ...lessons.map((lesson) => el("li", {}, choice(lesson.title, `${lesson.stops} steps`, () => choose(lesson))))));
}
