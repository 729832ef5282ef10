// The text is in a window beside the canvas, which shows the lesson at the step of the cursor. Mistakes are reported
// with their line during typing.
import { makeRoom, openWindow, problemLine } from "../kit/dialogs.js";
import { button, download, el } from "../kit/elements.js";
import { fetchJson } from "../kit/fetched.js";
import { number } from "../words/numbers.js";
import { lowered, say, translated } from "../words/words.js";
import { lasting, ofThisTab, read, write } from "../page/storage.js";
import { unreadable } from "../page/lesson_text.js";
import { underWay } from "../page/under_way.js";
import { noSample, openLessonText, titleOf } from "./lesson_source.js";
import { openLessonOf, standing, watch } from "./lesson_watch.js";
import { fetchLessons } from "./ready_made.js";

const draftKey = "evenlift.lesson-draft";
const pause = 350; // ms after the last letter

// For any method: the template keeps those that the algorithm takes.
const firstSteps = [
  ["centre", "What should they notice here? Ask before you explain."],
  ["vertex 1", "A chord from the first vertex through C."],
  ["directions", "Directions at equal angles, one for each team."],
  ["candidates", "All chords that meet the minimum ratio."],
  ["team 1", "The first team, and why this one was chosen."],
  ["lever", "Two robots, and the load of each."],
  ["rest", "Some robots have their places. Where must the others stand so that all can carry the same load?"],
  ["start 1", "The first robots whose centroid is C."],
  ["end", "What should they remember?"],
];

const inText = (steps) => steps.map(([address, words]) => `[${address}]\n${translated(words)}\n`).join("\n");

// About the open polygon, unless its link is long.
function template(program) {
  const link = program.text("page_link");
  const begin = `${translated("# Lines that begin with # are notes for the author.")}
title: ${translated("My lesson")}
`;
  const own = link && link.length < 2000;
  const about = (steps) => `${begin}${own ? `link: ${link}` : "polygon: trapezium"}\n\n${inText(steps)}`;
  // The sample's teams are chosen by area, which has only these steps.
  const ofSample = new Set(["centre", "vertex 1", "candidates", "team 1", "end"]);
  const there = own ? program.json("page_steps_that_exist", about(firstSteps)) : null;
  return `${about(firstSteps.filter(([address], i) => (there ? there[i] : ofSample.has(address))))}
${translated("# On the card at the end. The answer appears when they ask for it.")}
[question]
${translated("What could they find out by themselves?")}

[answer]
${translated("What they will find.")}
`;
}

const option = (value, name) => el("option", { value }, name);

// Each sample has a twin with another centre of mass, which the gallery omits.
function choiceOfSamples(names, gallery) {
  const twin = /-moved$/;
  const groups = new Map();
  const add = (group, name, title) => groups.set(group, [...(groups.get(group) ?? []), option(name, title)]);
  const titles = new Map(gallery.map(({ name, title }) => [name, title]));
  for (const { name, title, group } of gallery.filter((sample) => names.includes(sample.name)))
    add(group || "To begin with", name, title);
  for (const name of names.filter((each) => !titles.has(each))) {
    const title = titles.get(name.replace(twin, ""));
    if (title && twin.test(name)) add("With a moved centre of mass", name, say("{title}, moved", { title }));
    else add("Others", name, name.charAt(0).toUpperCase() + name.slice(1).replaceAll("-", " "));
  }
  return [...groups].map(([label, options]) => el("optgroup", { label: translated(label) }, ...options));
}

export async function show(page) {
  if (document.getElementById("editor")) return;
  const samples = await fetchJson("polygons.json").catch(() => ({}));
  const gallery = await fetchJson("samples.json").catch(() => []);
  const lessons = await fetchLessons().catch(() => []);
  const editor = new Editor(page, samples, lessons, gallery);
  const root = await openWindow({
    name: "editor",
    title: "Write a lesson",
    modal: false,
    body: [
      el("div", { class: "row" }, editor.beginWith, editor.aboutSample),
      editor.field,
      editor.problem,
      editor.toLine,
      editor.status,
      el("footer", {}, editor.help, editor.copy, editor.save),
    ],
    focus: editor.field,
    closed: () => editor.close(),
  });
  if (root) editor.connect(root);
}

class Editor {
  #page;
  #samples; // by name
  #due; // the next update of the canvas: { timer, done }
  #shown = {}; // on the canvas: { text, stop }
  #before; // the lesson that was open before, if any: { name, text, at }
  #begun; // with which the editor began
  #wrong = ""; // the problem of the text, if any
  #leave = new AbortController();

  constructor(page, samples, lessons, gallery) {
    this.#page = page;
    this.#samples = samples;
    this.field = el("textarea", {
      class: "field",
      spellcheck: "true",
      "aria-label": "The lesson’s text",
      "aria-describedby": "editor-problem",
      wrap: "soft",
    });
    this.field.value = read(ofThisTab, draftKey) || read(lasting, draftKey) || template(page.program);
    this.#begun = this.field.value;
    const open = openLessonOf(page.program);
    if (open) this.#before = { ...open, at: standing(page.program).at };
    this.problem = problemLine({ id: "editor-problem", role: "status" });
    // Long lines wrap, so lines cannot be counted by eye.
    this.toLine = button("", { class: "button to-line", hidden: "", onclick: () => this.#goToLine() });
    this.status = el("p", { class: "second status", role: "status" });
    this.beginWith = this.#beginWith(lessons);
    this.aboutSample = el(
      "select",
      { class: "field", "aria-label": "Sample polygon", onchange: () => this.#insertSample() },
      option("", "About a sample …"),
      ...choiceOfSamples(Object.keys(samples), gallery),
    );
    this.save = button("Save as a file", { class: "button primary", onclick: () => this.#save() }, "save");
    this.copy = button("Copy link to this lesson", { onclick: () => underWay(this.#copyLink()) }, "copy");
    this.help = el(
      "a",
      { class: "second", href: new URL("docs-lessons.html", import.meta.url).href, target: "_blank", rel: "noopener" },
      "How to write a lesson",
    );
  }

  #beginWith(lessons) {
    const open = openLessonOf(this.#page.program);
    const texts = [
      { name: "template", title: "A template", text: () => template(this.#page.program) },
      ...(open ? [{ name: "open", title: "The open lesson", text: () => open.text }] : []),
      ...lessons.map(({ name, title, text }) => ({ name: `lesson ${name}`, title, text: () => text })),
    ];
    const list = el(
      "select",
      {
        class: "field",
        "aria-label": "Begin with",
        onchange: () => {
          const chosen = texts.find(({ name }) => name === list.value);
          list.value = "";
          if (chosen) this.#replace(0, this.field.value.length, chosen.text());
        },
      },
      option("", "Begin with …"),
      ...texts.map(({ name, title }) => option(name, title)),
    );
    return list;
  }

  connect(root) {
    const { signal } = this.#leave;
    this.field.addEventListener("input", () => this.#soon(), { signal });
    document.addEventListener("selectionchange", () => document.activeElement === this.field && this.#soon(), {
      signal,
    });
    // Tab leaves the text; Escape closes the window, and the draft stays.
    root.addEventListener(
      "keydown",
      (event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        root.close();
      },
      { signal },
    );
    this.field.setSelectionRange(0, 0);
    this.field.scrollTop = 0;
    signal.addEventListener("abort", makeRoom(this.#page.program, root));
    this.#look();
  }

  // Without an edit, the previous document comes back.
  close() {
    this.#leave.abort();
    const { program } = this.#page;
    if (this.field.value !== this.#begun) {
      const { text } = this.#shown;
      if (text !== undefined) this.#page.nameLesson(program.json("page_lesson_link", text).text);
      return this.#keep();
    }
    if (!this.#shown.text) return;
    program.number("page_key", "z", 1, 0);
    if (this.#before) underWay(this.#reopen(this.#before));
  }

  async #reopen({ name, text, at }) {
    const problem = await openLessonText(this.#page, text, name);
    if (!problem) this.#page.program.call("page_go_to_stop", at);
  }

  // Keeps the draft for this tab, out of reach of other tabs, and for the next visit.
  #keep() {
    for (const storage of [ofThisTab, lasting]) write(storage, draftKey, this.field.value);
  }

  #soon() {
    clearTimeout(this.#due?.timer);
    if (!this.#due) {
      this.#due = {};
      underWay(
        new Promise((done) => {
          this.#due.done = done;
        }),
      );
    }
    this.#due.timer = setTimeout(() => {
      const { done } = this.#due;
      this.#due = undefined;
      if (!this.#leave.signal.aborted) this.#look();
      done();
    }, pause);
  }

  // The last valid lesson stays on the canvas.
  #look() {
    const text = this.field.value;
    this.#keep();
    const isNew = text !== this.#shown.text;
    const problem = isNew ? this.#open(text) : "";
    this.#say(problem);
    if (problem) return;
    if (isNew) {
      this.#shown = { text };
      watch(this.#page, { text });
    }
    const { program } = this.#page;
    const stop = this.#stopAt(this.field.selectionStart);
    if (stop !== this.#shown.stop) {
      this.#shown.stop = stop;
      program.call("page_go_to_stop", Math.max(stop, 0));
    }
    const steps = this.#stopAt(text.length) + 1;
    const counted = steps === 1 ? "1 step" : say("{steps} steps", { steps });
    this.status.textContent =
      stop < 0
        ? say("{steps}; the drawing shows the first.", { steps: counted })
        : say("{steps}; the drawing shows step {step}.", { steps: counted, step: stop + 1 });
  }

  #say(problem) {
    this.#wrong = problem;
    this.problem.say(problem);
    this.line = Number(new RegExp(`^${say("Line {line}", { line: "(\\d+)" })}`, "i").exec(problem)?.[1] ?? 0);
    this.toLine.hidden = !this.line;
    this.toLine.textContent = say("Go to line {line}", { line: this.line });
    if (problem) {
      this.status.textContent = translated("The drawing shows the last version without a mistake.");
      this.field.setAttribute("aria-invalid", "true");
    } else {
      this.field.removeAttribute("aria-invalid");
    }
  }

  #goToLine() {
    const lines = this.field.value.split("\n"),
      before = lines.slice(0, this.line - 1).join("\n").length + (this.line > 1 ? 1 : 0);
    this.field.focus();
    this.field.setSelectionRange(before, before + (lines[this.line - 1] ?? "").length);
  }

  #open(text) {
    const { program } = this.#page;
    const why = unreadable(text);
    if (why) return why;
    const sample = program.text("page_lesson_polygon", text);
    if (sample && !Object.hasOwn(this.#samples, sample)) {
      const line = text.split("\n").findIndex((each) => /^polygon\s*:/.test(each.trim())) + 1;
      return say("Line {line}: {problem}", { line, problem: lowered(noSample(sample, Object.keys(this.#samples))) });
    }
    const problem = program.text("page_open_lesson", text, sample ? this.#samples[sample] : "", 2, 1);
    if (!problem) this.#page.nameLesson("");
    return problem;
  }

  // The index of the step at a position; -1 among the settings. The question belongs to the last step.
  #stopAt(position) {
    const end = this.field.value.indexOf("\n", position);
    const before = this.field.value.slice(0, end < 0 ? undefined : end);
    return before.split("\n").filter((line) => /^\s*\[(?!\s*(question|answer)\s*\])/.test(line)).length - 1;
  }

  // Writes the sample over the lesson's polygon, or else below its title.
  #insertSample() {
    const name = this.aboutSample.value;
    this.aboutSample.value = "";
    if (!name) return;
    const line = `polygon: ${name}`,
      text = this.field.value;
    const former = /^(polygon|link)[ \t]*:.*$/m.exec(text);
    if (former) return this.#replace(former.index, former.index + former[0].length, line);
    const title = /^title[ \t]*:.*$/m.exec(text);
    const below = title ? title.index + title[0].length : 0;
    this.#replace(below, below, title ? `\n${line}` : `${line}\n`);
  }

  // As if typed, so that the field's own undo reverts it.
  #replace(from, to, text) {
    this.field.focus();
    this.field.setSelectionRange(from, to);
    if (!document.execCommand("insertText", false, text)) this.field.setRangeText(text, from, to, "end");
    this.field.setSelectionRange(from, from);
    this.field.scrollTop = 0;
    this.#soon();
  }

  async #copyLink() {
    this.#look(); // at the text typed last
    if (this.#wrong)
      return this.problem.say(say("Correct the lesson before you link to it: {why}", { why: lowered(this.#wrong) }));
    const { text, problem } = this.#page.program.json("page_lesson_link", this.field.value);
    if (problem) return this.problem.say(problem);
    const address = this.#page.lessonAddress(text);
    if (!(await this.#page.copy(address))) return this.problem.say("The browser did not allow copying");
    this.status.textContent = say("The link is copied. It holds the whole lesson, in {number} characters.", {
      number: number(address.length),
    });
  }

  #save() {
    const name =
      titleOf(this.field.value)
        .normalize("NFKD")
        .toLowerCase()
        .replace(/[^a-z0-9]+/g, "-")
        .replace(/^-|-$/g, "") || "lesson";
    download(new Blob([this.field.value], { type: "text/plain" }), `${name}.txt`);
  }
}
