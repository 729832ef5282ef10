// Opens texts, files and links from outside. A function that opens something returns why it was refused, or nothing.
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, lowered, number } from "../kit/elements.js";
import { openLessonText } from "./lesson_source.js";
import { isLesson } from "../page/lesson_text.js";
import { svgToText } from "../kit/svg_import.js";
import { underWay } from "../page/under_way.js";

const mostBytes = 64 * 1024 * 1024;  // core/include/evenlift/document.h
const tooLong = (bytes) => bytes > mostBytes && `It has ${number(Math.ceil(bytes / 1048576))} MiB, more than the 64 that evenlift reads`;

async function openText(page, text, how = "page_load") {
  if (tooLong(text.length)) return tooLong(text.length);
  if (!text.trim()) return "It is empty";
  if (text.includes("\0")) return "It is not a text";
  if (how === "page_load" && isLesson(text)) return openLessonText(page, text);
  if (!/^\s*</.test(text)) return page.program.text(how, text);
  const svg = svgToText(text);
  return svg.problem ?? page.program.text(how, svg.text);
}

async function openFile(page, file) {
  if (tooLong(file.size)) return tooLong(file.size);
  let text;
  try {
    text = await file.text();
  } catch {
    return "It cannot be read";
  }
  return openText(page, text);
}

const undo = "Undo brings back the previous polygon.";

// Opens what was dropped or pasted anywhere on the page. If that fails, the window says why, or else a notice.
export async function take(page, { files, text }, verb) {
  if (files.length > 1) return refuse(page, "Please open one file at a time");
  const [file] = files;
  const problem = file ? await openFile(page, file) : await openText(page, text);
  const what = file ? `“${file.name}”` : `The ${verb} text`;
  if (problem) return refuse(page, `${what} cannot be opened: ${lowered(problem)}`);
  for (const root of document.querySelectorAll("dialog:modal")) root.close();
  page.notice(`${what} is opened. ${undo}`);
}

function refuse(page, sentence) {
  const line = document.querySelector("#open .problem");
  if (line) line.say(sentence);
  else page.notice(`${sentence.replace(/\.$/, "")}.`, true);
}

const formats = "text (x,y), WKT, GeoJSON, SVG, a share link, or a lesson";

// The window. With `edited` it shows the present polygon as text, and applying it keeps the settings.
export async function show(page, { edited } = {}) {
  const problem = problemLine({ id: "open-problem" });
  const text = el("textarea", { class: "field", rows: "9", spellcheck: "false", autocapitalize: "off", "aria-label": edited ? "The polygon as text" : "Polygon or link",
    "aria-describedby": "open-problem", placeholder: "(0,0)\n(160,0)\n(160,90)\n(0,60)" });
  text.value = edited ?? "";
  const done = (why, message) => {
    problem.say(why);
    if (why) return text.focus();
    root?.close();
    page.notice(message);
  };
  const apply = async () => done(await underWay(openText(page, text.value, edited === undefined ? "page_load" : "page_open_sample")), `The text is opened. ${undo}`);
  const file = el("input", { type: "file", id: "open-file", class: "for-readers", tabindex: "-1", "aria-hidden": "true", accept: ".txt,.wkt,.json,.geojson,.svg,text/plain,application/geo+json,image/svg+xml" });
  file.addEventListener("change", async () => {
    const [chosen] = file.files;
    file.value = "";  // the same file may be chosen again
    if (!chosen) return;
    const why = await underWay(openFile(page, chosen));
    done(why && `“${chosen.name}” cannot be opened: ${lowered(why)}`, `“${chosen.name}” is opened. ${undo}`);
  });
  text.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    apply();
  });
  const choose = button("Choose a file …", { onclick: () => file.click() }, "file");
  const help = el("p", { class: "second" }, edited === undefined ? `Drop a file anywhere on the page, or paste here: ${formats}.` : "Settings stay as they are. An optional first line CoM:(x,y) is the centre of mass.");
  const root = await openWindow({
    name: "open",
    title: edited === undefined ? "Open a polygon" : "Edit as text",
    body: [el("div", { class: "scroll" }, help, text, problem), el("footer", {}, ...(edited === undefined ? [choose, file] : []),
      button(edited === undefined ? "Open" : "Apply", { class: "button primary", title: "Ctrl+Enter", onclick: apply }))],
    focus: matchMedia("(pointer: fine)").matches ? text : choose,
  });
}
