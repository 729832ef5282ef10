// The coordinates of vertices, robots or weights, as a table beside the canvas. Typing changes the drawing; dragging
// changes the table.
import { makeRoom, openWindow, problemLine } from "../kit/dialogs.js";
import { button, el } from "../kit/elements.js";
import { say, translated } from "../words/words.js";
import { asRead } from "../words/numbers.js";
import { settingValue, typedProblem } from "../mirror/typed.js";
import { show as openText } from "./open.js";
import { underWay } from "../page/under_way.js";

const name = "table";
const most = 500; // rows on a page

// The page's functions, with the names of their buttons; `one` heads the names, and `typed` are the columns that can be
// typed. Robots also have a load; typing a place makes them robots placed by hand. Vertices of holes have a name of
// their own.
const lists = {
  vertices: {
    one: "Vertex",
    many: "Vertices",
    row: "Vertex {name}",
    count: "page_vertex_count",
    read: "page_vertices",
    write: "page_set_coordinate",
    remove: ["page_remove_vertex", "Delete vertex", "Delete vertex {number}"],
    pointed: "page_hovered_vertex",
    select: "page_select_vertex",
    label: "page_vertex_name",
    columns: ["x", "y"],
    typed: ["x", "y"],
    digits: 9,
    least: 3,
  },
  robots: {
    one: "Robot",
    many: "Robots",
    row: "Robot {name}",
    count: "page_robot_count",
    read: "page_robots",
    write: "page_set_robot",
    remove: ["page_remove_robot", "Delete robot", "Delete robot {number}"],
    pointed: "page_hovered_robot",
    select: "page_point_at_robot",
    add: ["page_add_robot", "Add a robot"],
    columns: ["x", "y", "Name", "Reads", "Load"],
    typed: ["x", "y", "name", "reads"],
    digits: 6,
    least: 1,
  },
  weights: {
    one: "No.",
    many: "Weights",
    row: "Weight {name}",
    count: "page_weight_count",
    read: "page_weights",
    write: "page_set_weight",
    remove: ["page_remove_weight", "Delete weight", "Delete weight {number}"],
    pointed: "page_hovered_weight",
    select: "page_select_weight",
    add: ["page_add_weight", "Add a weight"],
    columns: ["x", "y", "Weight", "Name"],
    typed: ["x", "y", "weight", "name"],
    digits: 5,
    least: 0,
  },
};

const reading = lists.robots.typed.indexOf("reads");

// Readings of robots while others have none, and the places of those robots: they stay when the table is closed.
const waiting = { readings: new Map(), of: "" };

// Opens the list of robots, for their readings.
export const weigh = (page) => show(page, { list: lists.robots });

export async function show(page, { list } = {}) {
  const open = document.getElementById(name);
  if (open?.open) {
    open.close(); // the same key opens and closes the table
    if (!list) return;
  }
  const table = new Table(page);
  const weighs = list === lists.robots; // then names are not of use, until a list is chosen
  const root = await openWindow({
    name,
    title: weighs ? "Weigh it" : "Coordinates",
    modal: false,
    tools: [table.whole],
    body: [
      table.choice,
      table.refusal,
      table.problem,
      table.scroll,
      el("footer", {}, table.pager, table.centre.row, table.weighed.row, table.more),
    ],
    closed: () => table.disconnect(),
  });
  if (root) table.connect(root, list);
  table.scroll.classList.toggle("weighs", weighs);
}

class Table {
  #page;
  #list = lists.vertices;
  #rows = []; // of the current page
  #from = 0; // the first vertex or robot of that page
  #selected = -1;
  #told = ""; // about what was taken over
  #leave = new AbortController();
  #due; // of the next update

  constructor(page) {
    this.#page = page;
    this.refusal = problemLine({ class: "refusal", role: "status" });
    this.problem = problemLine();
    this.head = el("thead");
    this.body = el("tbody");
    this.scroll = el("div", { class: "scroll" }, el("table", {}, this.head, this.body));
    this.choice = el(
      "div",
      { class: "row lists", role: "group", "aria-label": "What the table lists" },
      ...Object.values(lists).map((list) =>
        button(list.many, { class: "button bare", "aria-pressed": "false", onclick: () => this.#take(list) }),
      ),
    );
    this.more = button("", {
      onclick: () => {
        this.#program.call(this.#list.add[0]);
        this.#go(this.#program.number(this.#list.count) - 1);
      },
    });
    this.whole = button("Edit as text", {
      class: "button bare",
      onclick: () => openText(page, { edited: this.#text() }),
    });
    this.centre = this.#centreRow();
    this.weighed = this.#weighedRow();
    this.pager = this.#pagerRow();
  }

  connect(root, list = lists.vertices) {
    const { signal } = this.#leave;
    const soon = () => this.#soon();
    document.addEventListener("evenlift-change", soon, { signal });
    signal.addEventListener("abort", makeRoom(this.#page.program, root));
    // The selection and the vertex under the pointer are known only after the canvas was drawn.
    const canvas = document.getElementById("canvas");
    for (const type of ["pointermove", "pointerup", "pointerleave", "keyup"])
      canvas.addEventListener(type, soon, { signal });
    root.addEventListener("keydown", (event) => this.#key(event, root));
    root.addEventListener("change", (event) => this.#commit(event.target));
    root.addEventListener("focusin", ({ target }) => {
      const vertex = this.#vertexOf(target);
      if (target.matches("input")) {
        if (target.value === target.dataset.shown) target.value = target.dataset.is;
        target.select();
      }
      if (vertex < 0 || vertex === this.#selected) return;
      this.#selected = vertex;
      this.#program.call(this.#list.select, vertex);
      soon();
    });
    root.addEventListener("focusout", ({ target }) => {
      if (target.matches("input") && target.value === target.dataset.is) target.value = target.dataset.shown;
    });
    this.#selected = this.#program.number("page_selected_vertex");
    if (this.#selected >= 0) this.#from = this.#pageOf(this.#selected);
    this.#take(list);
    // On a phone, a keyboard that opens by itself would hide half of the table.
    if (!matchMedia("(pointer: fine)").matches) return;
    if (list === lists.vertices) this.#focus(Math.max(this.#selected, 0) - this.#from, 0);
    else this.#focus(0, list.typed.length - 1);
  }

  disconnect() {
    this.#leave.abort();
  }

  get #program() {
    return this.#page.program;
  }

  #take(list) {
    this.#list = list;
    this.scroll.classList.remove("weighs");
    this.#rows = [];
    this.#from = list === lists.vertices ? this.#from : 0;
    const heads = [list.one, ...list.columns];
    this.head.replaceChildren(
      el("tr", {}, ...heads.map((head) => el("th", { scope: "col", class: head }, head)), el("td", {})),
    );
    Object.values(lists).forEach((each, i) => {
      this.choice.children[i].setAttribute("aria-pressed", String(each === list));
    });
    const vertices = list === lists.vertices;
    if (!vertices) this.#program.call("page_select_vertex", -1);
    this.scroll.classList.toggle("many", list.typed.length > 2);
    this.whole.hidden = !vertices;
    this.centre.row.hidden = !vertices;
    this.#told = "";
    if (waiting.of !== this.#places()) waiting.readings.clear();
    this.more.hidden = vertices;
    this.more.textContent = vertices ? "" : translated(list.add[1]);
    this.problem.say("");
    this.#refresh();
  }

  #text() {
    return this.#program.text("page_document_text");
  }

  // --- Rows --------------------------------------------------------------------------------------

  #inputs(what, columns = ["x", "y"]) {
    return columns.map((axis) =>
      el("input", {
        class: "field",
        inputmode: axis === "name" ? "text" : "decimal",
        autocomplete: "off",
        spellcheck: "false",
        "aria-label": `${what}, ${translated(axis)}`,
      }),
    );
  }

  #row(vertex) {
    const {
      row: rowName,
      remove: [removes, ...removing],
      count,
      columns,
      typed,
      label,
    } = this.#list;
    const name = label ? this.#program.text(label, vertex) : String(vertex + 1);
    const inputs = this.#inputs(say(rowName, { name }), typed);
    const act = ([title, pattern], picture, run) =>
      button(
        "",
        { class: "button bare", "aria-label": say(pattern, { number: vertex + 1 }), title, onclick: run },
        picture,
      );
    const insert = act(["Insert a vertex after", "Insert a vertex after {number}"], "plus", () => {
      this.#program.call("page_insert_vertex", vertex);
      this.#refresh();
      this.#go(vertex + 1);
    });
    const remove = act(removing, "close", () => {
      const before = this.#program.number(count);
      this.#program.call(removes, vertex);
      if (this.#list === lists.robots && this.#program.number(count) < before) this.#forget(vertex);
      this.#refresh();
      const acts = typed.length + (this.#list === lists.vertices ? 1 : 0);
      this.#go(Math.min(vertex, this.#program.number(count) - 1), acts);
    });
    const load = columns.length > typed.length ? [el("td", { class: "load" })] : [];
    const row = el(
      "tr",
      {},
      el("th", { scope: "row" }, name),
      ...inputs.map((input, i) => el("td", { class: columns[i] }, input)),
      ...load,
      el("td", { class: "acts" }, ...(this.#list === lists.vertices ? [insert] : []), remove),
    );
    return { row, inputs, remove, load: load[0], vertex, name };
  }

  #centreRow() {
    const inputs = this.#inputs(translated("Centre of mass"));
    const release = button("Back to centroid", {
      onclick: () => {
        this.#program.call("page_release_centre");
        inputs[0].focus();
      },
    });
    return {
      row: el(
        "div",
        { class: "row centre", role: "group", "aria-label": "Centre of mass" },
        el("span", { class: "name" }, "Centre of mass"),
        release,
        ...inputs,
      ),
      inputs,
      release,
      vertex: -1,
    };
  }

  // What the robots' readings tell.
  #weighedRow() {
    const said = el("p", { class: "second", role: "status" });
    const takeOver = button("Take over", {
      title: "Makes this weight and C the object's, so that any method can place robots for it",
      onclick: () => {
        this.#program.call("page_take_over");
        this.#told = translated("The weight and C are the object's now, without the readings. Undo brings them back.");
        this.#refresh();
        if (matchMedia("(pointer: fine)").matches) this.#focus(0, reading); // the button is gone
      },
    });
    // More robots stood there than scales.
    const others = button("", {
      onclick: () => {
        const all = this.#reads();
        all.forEach((_, i) => {
          const robot = all.length - 1 - i;
          if (all[robot] !== "") return;
          this.#program.call("page_remove_robot", robot);
          this.#forget(robot);
        });
        this.#refresh();
        if (takeOver.hidden) return;
        takeOver.focus(); // the button is gone
      },
    });
    const doubt = el("p", { class: "doubt", role: "status" });
    return {
      row: el("div", { class: "weighed" }, el("div", { class: "row" }, said, takeOver, others), doubt),
      said,
      doubt,
      takeOver,
      others,
    };
  }

  // The robots, with all that is known of their readings.
  #robots() {
    const program = this.#program;
    const list = lists.robots;
    return program.json(list.read, 0, program.number(list.count));
  }
  #places() {
    return JSON.stringify(this.#robots().map(([x, y]) => [x, y]));
  }
  #reads() {
    return this.#robots().map((values, i) => waiting.readings.get(i) ?? String(values[reading]));
  }

  // Readings count once each robot has one; until then they wait.
  #setReading(robot, text) {
    if (text && !(Number(text) >= 0)) return say("“{value}” is not a weight of 0 or more", { value: text });
    const all = this.#reads();
    all[robot] = text;
    return this.#weigh(all);
  }

  #weigh(all) {
    const program = this.#program;
    this.#told = "";
    waiting.readings = new Map(all.entries()); // one may have been cleared: the others stay
    const isWhole = all.every((value) => value !== "");
    const problem = program.text("page_set_readings", isWhole ? all.join(" ") : "none");
    if (isWhole ? !problem : all.every((value) => value === "")) waiting.readings.clear();
    waiting.of = this.#places();
    return problem;
  }

  // A reading goes with its robot.
  #forget(robot) {
    if (waiting.readings.size === 0) return;
    const all = [...waiting.readings].sort(([a], [b]) => a - b).map(([, value]) => value);
    all.splice(robot, 1);
    this.problem.say(this.#weigh(all));
  }

  #pagerRow() {
    const turn = (by) => {
      this.#from += by * most;
      this.#refresh();
      this.scroll.scrollTop = 0;
    };
    this.back = button("Previous", { onclick: () => turn(-1) });
    this.next = button("Next", { onclick: () => turn(1) });
    this.range = el("span", { class: "second", role: "status" });
    return el("div", { class: "row pager" }, this.back, this.range, this.next);
  }

  #pageOf(vertex) {
    return vertex - (vertex % most);
  }

  #soon() {
    this.#due ??= underWay(
      new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))).then(() => {
        this.#due = undefined;
        if (!this.#leave.signal.aborted) this.#refresh();
      }),
    );
  }

  #refresh() {
    const program = this.#program;
    const list = this.#list;
    const count = program.number(list.count);
    // Only vertices stay selected; a robot that somebody points at is marked.
    const selected = list === lists.vertices ? program.number("page_selected_vertex") : -1;
    const moved = selected !== this.#selected && list === lists.vertices;
    if (list === lists.vertices) this.#selected = selected;
    if (moved && selected >= 0) this.#from = this.#pageOf(selected);
    this.#from = Math.max(Math.min(this.#from, this.#pageOf(count - 1)), 0);
    const shown = Math.min(most, count - this.#from);
    const nameOf = (vertex) => (list.label ? program.text(list.label, vertex) : String(vertex + 1));
    const renamed = this.#rows.some(({ vertex, name }) => vertex < count && name !== nameOf(vertex));
    if (renamed || this.#rows.length !== shown || this.#rows[0]?.vertex !== this.#from) {
      const kept = renamed
        ? []
        : this.#rows.filter(({ vertex }) => vertex >= this.#from && vertex < this.#from + shown);
      this.#rows = Array.from(
        { length: shown },
        (_, i) => (kept[0]?.vertex === this.#from && kept[i]) || this.#row(this.#from + i),
      );
      this.body.replaceChildren(...this.#rows.map(({ row }) => row));
    }
    const pointed = program.number(list.pointed);
    program.json(list.read, this.#from, shown).forEach((values, i) => {
      const { row, inputs, remove, load, vertex } = this.#rows[i];
      if (list === lists.robots && waiting.readings.has(vertex)) values[reading] = asRead(waiting.readings.get(vertex));
      write(inputs, values.slice(0, inputs.length), list.digits);
      if (load) load.textContent = values[inputs.length];
      row.className = vertex === selected ? "selected" : vertex === pointed ? "hovered" : "";
      remove.disabled = count <= list.least;
    });
    write(this.centre.inputs, program.json("page_centre"), lists.vertices.digits);
    this.centre.release.disabled = !program.number("page_centre_is_given");
    this.refusal.say(program.text("page_refusal"));
    this.#tellWeighing();
    this.pager.hidden = count <= most;
    this.back.disabled = this.#from === 0;
    this.next.disabled = this.#from + shown >= count;
    this.range.textContent = say("{first}–{last} of {all}", {
      first: this.#from + 1,
      last: this.#from + shown,
      all: count,
    });
    if (moved && selected >= 0 && document.activeElement === document.getElementById("canvas"))
      this.#rows[selected - this.#from].row.scrollIntoView({ block: "nearest" });
  }

  #tellWeighing() {
    // They follow robots that move, and none that were added or belong to another object.
    if (waiting.readings.size > 0) {
      if (waiting.readings.size === this.#robots().length) waiting.of = this.#places();
      else waiting.readings.clear();
    }
    const ofRobots = this.#list === lists.robots;
    const [weighed, doubt] = ofRobots ? this.#program.json("page_weighed") : ["", ""];
    const missing = ofRobots && waiting.readings.size > 0 ? this.#reads().filter((value) => value === "").length : 0;
    const { row, said, takeOver, others } = this.weighed;
    const least = 3; // readings that tell where C is
    others.hidden = !(missing > 0) || this.#robots().length - missing < least;
    others.textContent = say(missing === 1 ? "Without the other robot" : "Without the other {number} robots", {
      number: missing,
    });
    row.hidden = !weighed && !missing && !this.#told;
    takeOver.hidden = !weighed || missing > 0;
    said.textContent = missing
      ? say("One robot for each scale, where it stands: {number} still missing.", { number: missing })
      : weighed || this.#told;
    this.weighed.doubt.textContent = missing ? "" : doubt;
    if (!ofRobots) return;
    // Beside the readings, what the model expects is another number.
    const heading = this.head.querySelector("th:last-of-type");
    heading.textContent = translated(weighed && !missing ? "Expected" : "Load");
    heading.title = weighed && !missing ? translated("Of equally stiff robots on even ground") : "";
  }

  // --- Keys and edits ----------------------------------------------------------------------------

  // The element's vertex or robot; -1 for the centre of mass, -2 for neither.
  #vertexOf(element) {
    if (this.centre.inputs.includes(element)) return -1;
    return this.#rows.find(({ row }) => row.contains(element))?.vertex ?? -2;
  }

  #commit(input) {
    const vertex = this.#vertexOf(input);
    if (vertex < -1) return;
    const { inputs } = vertex < 0 ? this.centre : this.#rows[vertex - this.#from];
    const axis = inputs.indexOf(input);
    if (input.value === input.dataset.is || input.value === input.dataset.shown) return this.#accept(input);
    const unit = this.#program.text("page_length_unit"),
      own = unit === "none" ? "" : unit;
    const isName = this.#list.typed[axis] === "name";
    const isReading = vertex >= 0 && this.#list.typed[axis] === "reads";
    const unitOfWeight = this.#program.text("page_weight_unit");
    const problem = isReading
      ? (input.value && typedProblem(input.value, "", unitOfWeight, false)) ||
        this.#setReading(vertex, input.value && settingValue(input.value, "", unitOfWeight))
      : (!isName && typedProblem(input.value, "", own, true)) ||
        this.#program.text(
          vertex < 0 ? "page_set_coordinate" : this.#list.write,
          vertex,
          axis,
          isName ? input.value : settingValue(input.value, "", own),
        );
    if (problem) {
      input.setAttribute("aria-invalid", "true");
      const name = input.getAttribute("aria-label");
      this.problem.say(problem.toLowerCase().includes(name.toLowerCase()) ? problem : `${name}: ${problem}`);
      return;
    }
    this.#accept(input);
    input.dataset.is = ""; // so that it appears again as the program writes it
    if (!input.value) input.dataset.shown = "";
    this.#refresh();
  }

  #accept(input) {
    input.removeAttribute("aria-invalid");
    if (
      !this.body.querySelector("[aria-invalid]") &&
      !this.centre.inputs.some((other) => other.hasAttribute("aria-invalid"))
    )
      this.problem.say("");
  }

  #key(event, root) {
    const { target: input, key } = event;
    const typed = input.matches("input") && input.value !== input.dataset.is;
    if (key === "Escape") {
      if (typed) {
        input.value = input.dataset.is;
        this.#accept(input);
      } else {
        root.close();
      }
    } else if ((event.ctrlKey || event.metaKey) && /^[zy]$/i.test(key)) {
      if (typed) return; // the field's own undo
      this.#program.number("page_key", key, 1, event.shiftKey ? 1 : 0);
    } else if (this.#tabsToOthers(event)) {
      this.weighed.others.focus();
    } else if ((/^(Enter|ArrowUp|ArrowDown)$/.test(key) && input.matches("input")) || this.#tabsDown(event)) {
      const up = key === "ArrowUp" || event.shiftKey;
      if (typed) this.#commit(input);
      const vertex = this.#vertexOf(input);
      if (vertex >= 0 && !input.hasAttribute("aria-invalid"))
        this.#focus(vertex - this.#from + (up ? -1 : 1), this.#rows[vertex - this.#from].inputs.indexOf(input));
    } else if (key === "Tab" && !event.shiftKey && input === this.#rows.at(-1)?.inputs[reading]) {
      if (typed) this.#commit(input);
      if (input.hasAttribute("aria-invalid") || this.weighed.takeOver.hidden) return;
      this.weighed.takeOver.focus(); // not the button that deletes this robot
    } else {
      return;
    }
    event.preventDefault();
  }

  // From reading to reading, not by the buttons that delete robots.
  #tabsDown({ target, key, shiftKey }) {
    if (key !== "Tab" || this.#list !== lists.robots) return false;
    const at = this.#rows.findIndex(({ inputs }) => inputs[reading] === target);
    return at >= 0 && Boolean(this.#rows[at + (shiftKey ? -1 : 1)]);
  }

  // From an empty reading.
  #tabsToOthers({ target, key, shiftKey }) {
    const leaves = key === "Tab" && !shiftKey && this.#list === lists.robots && target.value === "";
    return leaves && !this.weighed.others.hidden && this.#rows.some(({ inputs }) => inputs[reading] === target);
  }

  #go(vertex, column = 0) {
    this.#from = this.#pageOf(vertex);
    this.#refresh();
    this.#focus(vertex - this.#from, column);
  }

  // Columns: x, y, insert, delete.
  #focus(index, column) {
    const row = this.#rows[index]?.row;
    const cell = row?.querySelectorAll("input, button")[column];
    (cell?.disabled ? row.querySelector("input") : cell)?.focus();
    row?.scrollIntoView({ block: "nearest" });
  }
}

// A number with at most this many digits, until its field gets the focus; its value stays exact. What is 0 but for
// rounding, beside numbers as large as `largest`, is shown as 0.
function rounded(number, digits, largest) {
  if (Math.abs(number) < 1e-9 * largest) return "0";
  const text = String(number);
  return text.length > digits + 2 ? String(Number(number.toPrecision(digits - 1))) : text;
}

// Skips a field that is being typed in.
function write(inputs, values, digits) {
  const largest = Math.max(...values.slice(0, 2).map(Math.abs)); // of x and y
  values.forEach((given, axis) => {
    const input = inputs[axis],
      isNumber = typeof given === "number",
      value = isNumber ? asRead(String(given)) : given;
    if (input.dataset.is === value) return;
    const untouched = !input.dataset.is || input.value === input.dataset.is || input.value === input.dataset.shown;
    input.dataset.shown = isNumber ? asRead(rounded(given, digits, largest)) : value;
    if (untouched) {
      input.value = document.activeElement === input ? value : input.dataset.shown;
      input.removeAttribute("aria-invalid");
    }
    input.title = input.dataset.shown === value ? "" : value;
    input.dataset.is = value;
  });
}
