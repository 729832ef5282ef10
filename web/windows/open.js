// Opens texts, files and links from outside. Functions that open something return why it was refused, or undefined.
import { closeWindows, openWindow, problemLine } from "../kit/dialogs.js";
import { button, el } from "../kit/elements.js";
import { readShapes, textOf } from "../kit/import.js";
import { number } from "../words/numbers.js";
import { lowered, say, translated } from "../words/words.js";
import { nameOpened, openedName, stemOf } from "./document_name.js";
import { openLessonText, openLinkedLesson } from "../lessons/lesson_source.js";
import { linkedLesson } from "../page/address.js";
import { isLesson } from "../page/lesson_text.js";
import { isPhoto, layBehind, photoLine } from "../photo/photo.js";
import { showParts } from "./parts.js";
import { lengthInWords, sentences, showShapes, unitInWords } from "./shapes.js";
import { underWay } from "../page/under_way.js";

const mostBytes = 64 * 1024 * 1024; // core/include/evenlift/document.h
const tooLong = (bytes) =>
  bytes > mostBytes &&
  say("It has {number} MiB, more than the 64 that evenlift reads", { number: number(Math.ceil(bytes / 1048576)) });

// The last text with several shapes.
let several;

// A text that was typed or pasted into the window and not opened yet: it is there again.
let unopened = "";

// The last text whose curves were flattened, so that another tolerance can be chosen while its polygon is open.
let curved;

// `what` names the text in messages, `how` is the program's function, and `name` the file's (stemOf()), if any. A
// notice reports the result; of several shapes, a window lets the user choose.
async function openText(page, text, what, { how = "page_load", name = "" } = {}) {
  if (tooLong(text.length)) return tooLong(text.length);
  if (!text.trim()) return "It is empty";
  if (how === "page_load" && (isLesson(text) || linkedLesson(text))) {
    const problem = isLesson(text)
      ? await openLessonText(page, text)
      : await openLinkedLesson(page, linkedLesson(text));
    if (!problem) done(page, what);
    return problem;
  }
  // The program reads its own formats and links itself; a worker reads the others, with notes.
  if (/^\s*(\(|com\b|[^\s[{<]+\s*$)/i.test(text) && !page.program.text(how, text)) {
    nameOpened(page.program, name);
    return done(page, what);
  }
  return openShapes(page, { text, what, how, name });
}

// `more` are sentences for the notice.
function done(page, what, more = "") {
  unopened = "";
  closeWindows();
  const all = [say("{what} is opened.", { what }), more, translated("Undo brings back the previous polygon.")];
  page.notice(all.filter(Boolean).join(" "));
}

async function openShapes(page, source) {
  const found = await readShapes(source.text);
  if (found.problem) return found.problem;
  const { notes, shapes } = found;
  const said = [...unitInWords(found), ...notes.slice(0, 2)];
  if (shapes.length === 1 && !found.doubtful) return openShape(page, source, shapes[0], found, said);
  unopened = source.what === "The text" && source.how === "page_load" ? source.text : "";
  closeWindows();
  await chooseShape(page, source, found);
}

function chooseShape(page, source, found, tolerance) {
  const table = (now, flattened) => {
    several = { source, found: now, tolerance: flattened };
    return allShapes(page, source, now, flattened);
  };
  if (found.shapes.length > 1) several = { source, found, tolerance };
  return showShapes({
    ...source,
    found,
    tolerance,
    choose: (shape, now) => openShape(page, source, shape, now),
    all: table,
  });
}

// `found` may have been read again with another tolerance.
function allShapes(page, source, found, tolerance = 0) {
  return showParts(page, {
    ...source,
    found,
    tolerance,
    settings: page.program.text("page_settings_for_others"),
    open: (text, what) => {
      const problem = page.program.text("page_load", text);
      if (!problem) {
        nameOpened(page.program, source.name);
        done(page, what);
      }
      return problem;
    },
  });
}

// `said` is added to the notice; the window of shapes shows it itself.
function openShape(page, source, shape, found, said = []) {
  const { what, how, name } = source;
  const problem = page.program.text(how, textOf(shape, how === "page_load"));
  if (problem) return problem;
  nameOpened(page.program, name);
  const within = lengthInWords(shape.tolerance, found);
  curved = shape.tolerance
    ? { ...source, tolerance: shape.tolerance, within, origin: page.program.text("page_origin") }
    : undefined;
  const more = [
    ...said,
    ...(shape.tolerance ? [say("curves were flattened to within {within}, which “Open” can change", { within })] : []),
  ];
  done(page, what, sentences(more));
}

const picture = "It is a picture of a kind that cannot be shown behind the drawing. PNG, JPEG and WebP can";

async function openFile(page, file) {
  if (tooLong(file.size)) return tooLong(file.size);
  let bytes;
  try {
    bytes = new Uint8Array(await file.arrayBuffer());
  } catch {
    return "It cannot be read";
  }
  const head = String.fromCharCode(...bytes.subarray(0, 4));
  if (isPhoto(head, bytes)) return layBehind(page, file);
  if (/^(\x89PNG|\xff\xd8\xff|GIF8|BM|RIFF|II\*\0|MM\0\*)/.test(head)) return picture;
  // Spreadsheets write "Unicode text" as UTF-16.
  const encoding = head.startsWith("\xff\xfe") ? "utf-16le" : head.startsWith("\xfe\xff") ? "utf-16be" : "utf-8";
  return openText(page, new TextDecoder(encoding).decode(bytes), quoted(file), { name: stemOf(file.name) });
}

// Opens what was dropped or pasted anywhere on the page; `textName` is what a text is called. The window, if open, or
// else a notice shows a refusal.
export async function take(page, { files, text }, textName) {
  if (files.length > 1) return refuse(page, "Please open one file at a time");
  const [file] = files;
  const what = file ? quoted(file) : textName;
  const problem = file ? await openFile(page, file) : await openText(page, text, what);
  if (problem) refuse(page, refusal(what, problem));
}

const quoted = ({ name }) => say("“{name}”", { name });
const refusal = (what, problem) => say("{what} cannot be opened: {problem}", { what, problem: lowered(problem) });

function refuse(page, sentence) {
  const line = document.querySelector("#open .problem");
  if (line) line.say(sentence);
  else page.notice(`${translated(sentence).replace(/\.$/, "")}.`, true);
}

const formats =
  "lines (x,y), columns of a table (CSV), SVG, DXF, GeoJSON, WKT, a result (JSON), a share link, or a lesson; a photo or scan (PNG, JPEG, WebP) is shown behind the drawing for tracing";
const endings =
  ".png,.jpg,.jpeg,.webp,.txt,.csv,.tsv,.svg,.dxf,.json,.geojson,.wkt,text/plain,text/csv,text/tab-separated-values,image/svg+xml,image/vnd.dxf,application/json,application/geo+json";

// With `edited`, the window shows the present polygon as text, and applying it keeps the settings.
export async function show(page, { edited } = {}) {
  const problem = problemLine({ id: "open-problem" });
  const text = el("textarea", {
    class: "field",
    rows: "9",
    spellcheck: "false",
    autocapitalize: "off",
    "aria-label": edited ? "The polygon as text" : "Polygon or link",
    "aria-describedby": "open-problem",
    placeholder: "(0,0)\n(160,0)\n(160,90)\n(0,60)",
  });
  text.value = edited ?? unopened;
  const refused = (why) => {
    problem.say(why);
    if (why) text.focus();
  };
  const apply = async () =>
    refused(
      await underWay(
        openText(
          page,
          text.value,
          "The text",
          edited === undefined ? {} : { how: "page_apply_text", name: openedName(page.program) },
        ),
      ),
    );
  const file = el("input", {
    type: "file",
    id: "open-file",
    class: "for-readers",
    tabindex: "-1",
    "aria-hidden": "true",
    accept: endings,
  });
  file.addEventListener("change", async () => {
    const [chosen] = file.files;
    file.value = ""; // the same file may be chosen again
    if (!chosen) return;
    const why = await underWay(openFile(page, chosen));
    refused(why && refusal(quoted(chosen), why));
  });
  text.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    apply();
  });
  const choose = button("Choose a file …", { onclick: () => file.click() }, "file");
  const bring = matchMedia("(hover: none)").matches
    ? "Choose a file below, or paste here: {formats}."
    : "Drop a file anywhere on the page, or paste here: {formats}.";
  const help = el(
    "p",
    { class: "second" },
    edited === undefined
      ? say(bring, { formats })
      : "The settings do not change. An optional first line CoM:(x,y) is the centre of mass.",
  );
  await openWindow({
    name: "open",
    title: edited === undefined ? "Open a polygon" : "Edit as text",
    body: [
      el(
        "div",
        { class: "scroll" },
        help,
        text,
        problem,
        ...(edited === undefined ? [...againSeveral(page), ...againCurved(page), ...photoLine(page)] : []),
      ),
      el(
        "footer",
        {},
        ...(edited === undefined ? [choose, file] : []),
        button(edited === undefined ? "Open" : "Apply", {
          class: "button primary",
          title: "Ctrl+Enter",
          onclick: apply,
        }),
      ),
    ],
    focus: matchMedia("(pointer: fine)").matches ? text : choose,
  });
}

// The last text with several shapes, and a button that shows them all.
function againSeveral(page) {
  if (!several) return [];
  const { source, found, tolerance } = several;
  const show = () => {
    closeWindows();
    return allShapes(page, source, found, tolerance);
  };
  return [
    el(
      "p",
      { class: "row second again" },
      say("{what} has {number} shapes.", { what: source.what, number: number(found.shapes.length) }),
      button("All in a table …", { onclick: () => underWay(show()) }),
    ),
  ];
}

// How the last text's curves were flattened, and a button that changes it.
function againCurved(page) {
  if (!curved?.origin || curved.origin !== page.program.text("page_origin")) return [];
  const { what, tolerance, within } = curved;
  const change = async () => {
    const source = curved;
    const found = await readShapes(source.text, tolerance);
    closeWindows();
    await chooseShape(page, source, found, tolerance);
  };
  return [
    el(
      "p",
      { class: "row second again" },
      say("The curves of {what} were flattened to within {within}.", { what, within }),
      button("Change …", { onclick: () => underWay(change()) }),
    ),
  ];
}
