// Lessons of the page, texts, and files beside the page that an address names. Functions that open a lesson return why
// it was refused, or undefined.
import { ask, fetchJson } from "../kit/fetched.js";
import { lowered, say, translated } from "../words/words.js";
import { isLessonLink } from "../page/address.js";
import { unreadable } from "../page/lesson_text.js";
import { openLesson, watch } from "./lesson_watch.js";
import { fetchLessons } from "./ready_made.js";

const mostBytes = 65536; // core/include/evenlift/lesson.h
const patience = 15000; // ms

export function titleOf(text) {
  return /^title[ \t]*:(.*)$/m.exec(text)?.[1].trim() ?? "";
}

// `name` is the lesson's name in an address, if any; `how` is as for openLesson().
export async function openLessonText(page, text, name = "", how = {}) {
  const problem = unreadable(text);
  if (problem) return problem;
  // The name of a nameless lesson is a link that holds its text, so that every address of it opens it again.
  if (!name) name = page.program.json("page_lesson_link", text).text ?? "";
  const sample = page.program.text("page_lesson_polygon", text);
  if (!sample) return openLesson(page, { name, text }, how);
  let samples;
  try {
    samples = await fetchJson("polygons.json");
  } catch (error) {
    return say("Its polygon cannot be fetched: {why}", { why: error.message });
  }
  if (!Object.hasOwn(samples, sample)) return noSample(sample, Object.keys(samples));
  return openLesson(page, { name, text, polygon: samples[sample] }, how);
}

const quoted = (name) => translated("“{name}”").replace("{name}", name);

export function noSample(sample, names) {
  const near = names
    .map((name) => [distance(sample.toLowerCase(), name), name])
    .sort(([a, x], [b, y]) => a - b || (x < y ? -1 : 1))
    .slice(0, 3)
    .map(([, name]) => quoted(name));
  return say("It is about the sample {sample}, which does not exist; similar names are {names} and {last}", {
    sample: quoted(sample),
    names: near.slice(0, -1).join(", "),
    last: near.at(-1),
  });
}

// Letters to change, add or remove; less if one name contains the other.
function distance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, i) => i);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j)
      next[j] = Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1));
    row = next;
  }
  return row[b.length] - (a && (b.includes(a) || a.includes(b)) ? Math.min(a.length, b.length) : 0);
}

// A lesson's name in an address: a link, a ready-made lesson, or a text file in the page's folder or below. Others are
// refused: the author of a link must not choose what the reader's browser requests elsewhere.
const readyMade = /^[a-z0-9-]+$/;
const besideThePage = /^(?:[\w-][\w.-]*\/)*[\w-][\w.-]*\.txt$/;

export async function openNamedLesson(page, name, how) {
  if (isLessonLink(name)) {
    const { text, problem } = page.program.json("page_linked_lesson", name);
    return problem ?? openLessonText(page, text, "", how); // the link may have been found among other words
  }
  if (readyMade.test(name)) {
    const lesson = (await fetchLessons()).find((l) => l.name === name);
    return lesson ? openLesson(page, lesson, how) : "there is no ready-made lesson with that name";
  }
  if (!besideThePage.test(name) || name.length > 200)
    return "an address can name a ready-made lesson, or a .txt file in the page's own folder or below";
  const text = await read(
    await ask(new URL(name, location.href), { redirect: "error", signal: AbortSignal.timeout(patience) }),
  );
  return text === undefined ? "A lesson has at most 65,536 bytes" : openLessonText(page, text, name, how);
}

// For linkedLesson() (web/page/address.js): opens the document, then the lesson.
export async function openLinkedLesson(page, { lesson, link, number }) {
  const problem = link && page.program.text("page_open_link", link);
  return problem || openNamedLesson(page, lesson, { join: link !== "", number });
}

// Undefined for a text longer than a lesson may be, whose rest is not read.
async function read(answer) {
  const reader = answer.body.getReader();
  const decoder = new TextDecoder();
  let text = "";
  for (let bytes = 0; ;) {
    const { done, value } = await reader.read();
    if (done) return text + decoder.decode();
    bytes += value.length;
    if (bytes > mostBytes) {
      reader.cancel();
      return undefined;
    }
    text += decoder.decode(value, { stream: true });
  }
}

// Call this once the address's link is open. A challenge begins at the first step, whatever was open. Returns false if
// a lesson could not be opened.
export async function beginFromAddress(page, { lesson, number, challenge, join }) {
  let opens = true;
  if (lesson) {
    const problem = await openNamedLesson(page, lesson, { join, number }).catch((error) => error.message);
    opens = !problem;
    if (problem) {
      if (!isLessonLink(lesson)) page.nameLesson(""); // a link is the only copy of its lesson, so it stays
      const why = lowered(problem.replace(/^Link, /, ""));
      page.notice(
        isLessonLink(lesson)
          ? say("The lesson of this address cannot be opened: {why}.", { why })
          : say("The lesson “{name}” cannot be opened: {why}.", { name: lesson.slice(0, 60), why }),
        true,
      );
    }
  }
  if (!challenge) return opens;
  if (page.program.number("page_script")) {
    page.program.call("page_predict");
    page.program.call("page_go_to_stop", 0);
  } else {
    page.program.call("page_begin_walkthrough", 1);
  }
  if (!lesson) watch(page);
  return opens;
}
