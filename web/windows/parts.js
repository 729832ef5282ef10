// All shapes of a file, each with robots of its own: a table that is sorted by a press on a heading, whose rows open.
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, download, el } from "../kit/elements.js";
import { askOnce } from "../page/core.js";
import { asRead, number, readingsIn, withPointIn } from "../words/numbers.js";
import { asTyped, say, translated } from "../words/words.js";
import { lengthUnit, smallPicture } from "./shapes.js";

const atOnce = 200; // rows before "Show more"

// `key` gives what a row is sorted by: texts from the first to the last, numbers from the largest.
const firstColumns = [
  { head: "No.", key: ({ number: no }) => no, ascends: true },
  { head: "Name", key: ({ name }) => name, ascends: true },
  { head: "Size", key: ({ width, height }) => width * height },
  { head: "Weight", key: ({ weight }) => weight },
  { head: "Robots", key: ({ robots }) => robots },
];
// Of the columns of wasm/modules/kinds.h, and of verdicts, the worst first.
const heads = {
  "greatest load": "Greatest load",
  "least load": "Least load",
  coverage: "Covers",
  use: "Use",
  held: "Held",
};
const verdicts = { refused: "Refused", bad: "Bad", warning: "Warning", good: "Good" };
const worst = Object.keys(verdicts);

const inOrder =
  ({ key, ascends }) =>
  (a, b) => {
    const [one, other] = [key(a), key(b)];
    if (typeof one === "string") return one.localeCompare(other, "en", { numeric: true });
    return ((one ?? -Infinity) - (other ?? -Infinity)) * (ascends ? 1 : -1);
  };

const short = (value) => asRead(String(Number(value.toPrecision(4))));

// The typed texts; a decimal comma is read as a point.
function fields() {
  const field = (label, placeholder, about) => {
    const input = el("input", {
      class: "field",
      type: "text",
      size: "9",
      autocomplete: "off",
      spellcheck: "false",
      placeholder,
      title: about,
    });
    return { input, row: el("label", {}, label, " ", input) };
  };
  return {
    capacity: field("A robot carries", "as set", "Each part gets as many robots as it needs."),
    thickness: field("Thickness", "8", "In the unit of the drawing. The weight of each part follows from its area."),
    density: field("Density", "7850/m3", "Weight of a cubic metre (or cm3, mm3, in3)."),
    per_area: field("or weight by area", "62.8/m2", "Weight of a square metre (or cm2, mm2, in2)."),
  };
}

class Parts {
  #page;
  #source;
  #rows = [];
  #columns = [];
  #order; // a column, or none for that of the file
  #back = false; // sorted the other way
  #shown = atOnce;
  #stop;
  #csv = "";

  constructor(page, source) {
    this.#page = page;
    this.#source = source;
    this.problem = problemLine();
    this.told = el("p", { class: "second", role: "status" });
    this.bar = el("progress", { "aria-label": "Progress", max: "1", value: "0" });
    this.fields = fields();
    this.head = el("tr");
    this.body = el("tbody");
    this.more = button("", { onclick: () => this.#show(this.#shown + atOnce) });
    this.save = button("Save as CSV", { disabled: true, onclick: () => this.#download() }, "save");
    this.form = el(
      "form",
      {
        class: "row",
        onsubmit: (event) => {
          event.preventDefault();
          this.place();
        },
      },
      ...Object.values(this.fields).map(({ row }) => row),
      el("button", { type: "submit", class: "button primary" }, "Place robots"),
    );
    this.content = el(
      "div",
      { class: "scroll", tabindex: "0", role: "group", "aria-label": "The table" },
      el("table", {}, el("thead", {}, this.head), this.body),
      this.more,
    );
  }

  async place() {
    const fields = Object.entries(this.fields).map(([name, { input }]) => [name, input.value.trim()]);
    const [, doubtful] = fields.find(([, value]) => readingsIn(value)) ?? [];
    if (doubtful) {
      const values = { text: doubtful, ...readingsIn(doubtful) };
      return this.problem.say(say("“{text}” may mean {whole} or {decimal}: type one of these", values));
    }
    this.end();
    this.#stop = new AbortController();
    const { signal } = this.#stop;
    const typed = fields.map(([name, value]) => [name, withPointIn(value)]);
    this.#rows = [];
    this.#shown = atOnce;
    this.problem.say("");
    this.save.disabled = true;
    let count = 0;
    const progress = (found) => {
      if (signal.aborted) return;
      if (found.columns) {
        count = found.count;
        this.#begin(found.columns);
      } else {
        this.#rows.push(found);
        if (!this.#order && this.#rows.length <= this.#shown) this.body.append(this.#row(found));
      }
      this.#tell(this.#rows.length, count);
    };
    try {
      const { text, tolerance, settings } = this.#source;
      const request = { command: "place_parts", text, tolerance, settings, ...Object.fromEntries(typed) };
      const { csv, notes } = await askOnce(request, signal, progress);
      this.#csv = csv;
      this.problem.say(notes.join(" "));
      this.save.disabled = false;
      this.#show(this.#shown);
    } catch (error) {
      if (signal.aborted) return;
      this.bar.hidden = true;
      this.told.textContent = "";
      this.problem.say(error.message);
    }
  }

  end() {
    this.#stop?.abort(new DOMException("closed", "AbortError"));
  }

  #tell(done, count) {
    this.bar.hidden = done === count;
    this.bar.value = count ? done / count : 0;
    const refused = this.#rows.filter(({ verdict }) => verdict === "refused").length;
    const values = { done: number(done), count: number(count), refused: number(refused) };
    const said = [
      done < count ? say("Shape {done} of {count} …", values) : say("{count} shapes.", values),
      ...(refused ? [say("{refused} refused.", values)] : []),
      ...(done === count && count > 1 ? [translated("Press a heading to sort, a name to open.")] : []),
    ];
    this.told.textContent = said.join(" ");
  }

  #begin(columns) {
    const values = columns.map((name, i) => ({ head: heads[name] ?? name, key: ({ values }) => values[i], cell: i }));
    this.#columns = [
      ...firstColumns,
      ...values,
      { head: "Verdict", key: ({ verdict }) => worst.indexOf(verdict), ascends: true },
    ];
    this.#order = undefined;
    this.#back = false;
    this.head.replaceChildren(
      el("td"),
      ...this.#columns.map((column) =>
        el("th", { scope: "col" }, button(column.head, { class: "button bare", onclick: () => this.#sort(column) })),
      ),
    );
    this.head.children[3].title = say("in {unit}", { unit: lengthUnit(this.#source.found) });
    this.body.replaceChildren();
    this.more.hidden = true;
  }

  // Again for the other direction.
  #sort(column) {
    this.#back = this.#order === column && !this.#back;
    this.#order = column;
    const rises = (column.ascends ?? false) !== this.#back;
    this.#columns.forEach((each, i) => {
      const cell = this.head.children[i + 1];
      cell.querySelector("[aria-hidden]")?.remove();
      cell.removeAttribute("aria-sort");
      if (each !== column) return;
      cell.setAttribute("aria-sort", rises ? "ascending" : "descending");
      cell.firstChild.append(el("span", { "aria-hidden": "true" }, new Text(rises ? "↑" : "↓")));
    });
    this.#show(this.#shown);
  }

  #show(count) {
    this.#shown = count;
    const rows = [...this.#rows];
    if (this.#order) rows.sort(inOrder(this.#order));
    if (this.#back) rows.reverse();
    this.body.replaceChildren(...rows.slice(0, count).map((row) => this.#row(row)));
    this.#hideEmpty();
    const left = rows.length - this.body.rows.length;
    this.more.hidden = left <= 0;
    this.more.textContent = say("Show {number} more of {all}", {
      number: number(Math.min(left, atOnce)),
      all: number(left),
    });
  }

  // A column without a value, such as the use of robots that have no capacity.
  #hideEmpty() {
    this.#columns.forEach(({ cell }, i) => {
      const empty = cell !== undefined && this.#rows.every(({ values }) => values[cell] === null);
      for (const line of [this.head, ...this.body.rows]) line.cells[i + 1].hidden = empty;
    });
  }

  #row(part) {
    const { name, width, height, weight, robots, texts, verdict, problem } = part;
    const cell = (text) => el("td", {}, new Text(text));
    return el(
      "tr",
      {},
      el("td", {}, smallPicture(part, 48, 32)),
      cell(String(part.number)),
      el(
        "th",
        { scope: "row" },
        el("button", { type: "button", class: "button bare", onclick: () => this.#open(part) }, new Text(name)),
      ),
      cell(`${short(width)} × ${short(height)}`),
      cell(weight === null ? "" : short(weight)),
      cell(verdict === "refused" ? "" : String(robots)),
      ...texts.map((text) => cell(translated(text))),
      el("td", { class: `verdict ${verdict}` }, el("b", {}, verdicts[verdict]), " ", new Text(translated(problem))),
    );
  }

  #open(part) {
    const { what, open } = this.#source;
    const refused = open(part.open, say("{name} of {what}", { name: asTyped(part.name), what }));
    this.problem.say(refused);
    if (!refused) this.root.close();
  }

  #download() {
    const name = `${this.#source.name || "drawing"}-parts.csv`;
    download(new Blob([this.#csv], { type: "text/csv" }), name);
  }
}

// `source` has the text, its tolerance, what it is called in messages, the file's name (stemOf()), what was found in it
// (readShapes()), the settings of the page, and open(), which opens a part and returns why it was refused.
export async function showParts(page, source) {
  const parts = new Parts(page, source);
  const root = await openWindow({
    name: "parts",
    title: "All shapes of this file",
    body: [
      el("div", { class: "asked" }, parts.form, parts.problem, el("div", { class: "row" }, parts.told, parts.bar)),
      parts.content,
      el("footer", {}, parts.save),
    ],
    closed: () => parts.end(),
  });
  if (!root) return;
  parts.root = root;
  await parts.place();
}
