// Shows the shapes of a drawing, of which one is opened, and the permitted distance between its curves and edges.
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, svgEl, typedNumber } from "../kit/elements.js";
import { fitted, lineOf, pathOf } from "../kit/fit.js";
import { readShapes } from "../kit/import.js";
import { asRead, number } from "../words/numbers.js";
import { say, translated } from "../words/words.js";
import { underWay } from "../page/under_way.js";

const atOnce = 100; // shapes before "Show more"

export function smallPicture({ outline, holes }, width, height, part) {
  const place = fitted(outline, width, height, 4);
  const path = (shape, attributes) =>
    svgEl("path", {
      d: pathOf([shape.outline, ...shape.holes].map((ring) => ring.map(place))),
      "fill-rule": "evenodd",
      ...attributes,
    });
  return svgEl(
    "svg",
    { viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" },
    path({ outline, holes }, part && { class: "around" }),
    ...(part ? [path(part)] : []),
  );
}

// The shapes around this one, the outermost first.
function levels(shape, shapes) {
  const around = [];
  for (let at = shape.within; at !== null && at !== undefined; at = shapes[at].within) around.unshift(shapes[at]);
  return around;
}

// Where a shape lies: each shape around it with the next one in it, then the shape itself. Deeper levels leave out the
// outermost.
function pictures(shape, shapes) {
  const [most, around] = [2, levels(shape, shapes)];
  const chain = [...around.slice(-most), shape];
  if (chain.length === 1) return [smallPicture(shape, 96, 64)];
  const wide = 96 / chain.length + 16;
  return [
    el(
      "div",
      { class: "levels" },
      ...chain.flatMap((each, i) => [
        ...(i > 0 ? [el("span", { class: "second" })] : []),
        smallPicture(i + 1 < chain.length ? { ...each, holes: [] } : each, wide, 64, chain[i + 1]),
      ]),
    ),
  ];
}

function whereItIs(shape, shapes) {
  const around = levels(shape, shapes).at(-1);
  if (!around) return [];
  return [new Text(" "), el("span", { class: "second" }, around.sheet ? "on the sheet" : "inside another shape")];
}

// Only if some lines close no shape: they are pale and dashed, beside the offered shapes.
function wholeDrawing({ leftOpen: lines, shapes }) {
  if (lines.length === 0) return [];
  const offered = shapes.slice(0, atOnce).map(({ outline, holes }) => [outline, ...holes]);
  const [wide, high] = [420, 160];
  const place = fitted([...offered.flat(), ...lines].flat(), wide, high, 4);
  const drawn = (all) => all.map((points) => points.map(place));
  return [
    svgEl(
      "svg",
      { viewBox: `0 0 ${wide} ${high}`, "aria-hidden": "true" },
      ...offered.map((rings) => svgEl("path", { d: pathOf(drawn(rings)), "fill-rule": "evenodd" })),
      svgEl("path", { class: "open", d: drawn(lines).map(lineOf).join("") }),
    ),
    el("figcaption", { class: "second" }, "Dashed: lines that close no shape and are left out."),
  ];
}

// By its box: holes and letters are smaller than the object.
function largest(shapes) {
  const size = (points) =>
    [0, 1]
      .map((axis) => points.map((point) => point[axis]))
      .map((all) => all.reduce((a, b) => Math.max(a, b)) - all.reduce((a, b) => Math.min(a, b)));
  const areas = shapes.map((shape) => size(shape.outline).reduce((a, b) => a * b));
  return areas.indexOf(areas.reduce((a, b) => Math.max(a, b)));
}

// A line each for the name, the kind, and vertices, holes and size. The description is "NAME", KIND, VERTICES, SIZE or,
// with holes, "NAME", KIND, VERTICES, HOLES, SIZE. Vertices and holes are a number and a noun.
function inWords({ name, description }) {
  const parts = description.slice(name ? name.length + 4 : 0).split(", ");
  const size = parts
    .splice(/^[\d,]+ \p{L}+$/u.test(parts.at(-3)) ? -3 : -2)
    .join(", ")
    .replace(" x ", " × ");
  return [
    ...(name ? [el("b", {}, new Text(`${name} `))] : []),
    el("span", {}, parts.join(", "), " "),
    el("span", { class: "second" }, size),
  ];
}

export const sentences = (texts) => texts.map((text) => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`).join(" ");

// Many drawings have no unit.
export const lengthUnit = ({ unit }) => unit || "units of the drawing";

const ones = { inches: "inch", feet: "foot", "units of the drawing": "unit of the drawing" };
export function lengthInWords(length, found) {
  const many = lengthUnit(found);
  return `${length} ${translated(Number(length) === 1 ? (ones[many] ?? many.replace(/s$/, "")) : many)}`;
}

export const unitInWords = ({ unit }) => (unit ? [say("lengths are in {unit}", { unit })] : []);

function whatThereIs(what, { shapes, doubtful }) {
  const values = { what, number: number(shapes.length) };
  if (shapes.length > 1)
    return doubtful
      ? say(
          "{what} has {number} shapes, but what does not close is larger. Choose a shape to open all the same.",
          values,
        )
      : say("{what} has {number} shapes. Choose the one to open.", values);
  return doubtful
    ? say("{what} has a shape, but what does not close is larger. Choose a shape to open all the same.", values)
    : say("{what} has curves, but a polygon has straight edges.", values);
}

// `found` comes from readShapes. `choose` opens a shape, and returns why it was refused, or undefined; `all` shows the
// table of all shapes.
export async function showShapes({ what, text, found, tolerance = 0, choose, all }) {
  let readings = 0;
  const problem = problemLine();
  const notes = el("p", { class: "second" });
  const whole = el("figure", { class: "drawing" });
  const list = el("ul", { class: "shapes" });
  const more = button("", { onclick: () => show(list.childElementCount + atOnce) });
  const curves = el("input", {
    class: "field",
    type: "text",
    inputmode: "decimal",
    size: "8",
    autocomplete: "off",
    "aria-describedby": "shapes-curves",
  });
  const told = el("p", { class: "for-readers", role: "status" });
  const said = el("span", { class: "second", id: "shapes-curves" });
  const form = el(
    "form",
    {
      class: "row curves",
      onsubmit: (event) => {
        event.preventDefault();
        underWay(readAgain());
      },
    },
    el("label", {}, "Keep edges within ", curves),
    said,
    el("button", { type: "submit", class: "button" }, "Flatten"),
  );

  const open = (shape) => {
    const refused = choose(shape, found);
    problem.say(refused);
    if (!refused) root.close();
  };
  function show(count) {
    const shown = found.shapes.slice(list.childElementCount, count);
    list.append(
      ...shown.map((shape, i) =>
        el(
          "li",
          {},
          el(
            "button",
            {
              type: "button",
              class: "sample",
              tabindex: "-1",
              "data-index": list.childElementCount + i,
              onclick: () => open(shape),
            },
            ...pictures(shape, found.shapes),
            ...inWords(shape),
            ...whereItIs(shape, found.shapes),
          ),
        ),
      ),
    );
    const left = found.shapes.length - list.childElementCount;
    more.hidden = left === 0;
    more.textContent = say("Show {number} more of {all}", {
      number: number(Math.min(left, atOnce)),
      all: number(left),
    });
  }
  // Sheets come last, and are seldom what is looked for.
  const likely = () => {
    const parts = found.shapes.filter(({ sheet }) => !sheet);
    return list.querySelectorAll("button")[largest((parts.length ? parts : found.shapes).slice(0, atOnce))];
  };
  function fill() {
    list.replaceChildren();
    show(atOnce);
    whole.replaceChildren(...wholeDrawing(found));
    likely().tabIndex = 0;
    notes.textContent = sentences([...unitInWords(found), ...found.notes]);
    const flattened = found.shapes.filter((shape) => shape.tolerance).map((shape) => shape.tolerance);
    form.hidden = flattened.length === 0;
    const [least, most] = [Math.min(...flattened), Math.max(...flattened)];
    curves.value = least === most ? asRead(String(least)) : "";
    curves.placeholder =
      least === most ? "" : say("{least} to {most}", { least: asRead(String(least)), most: asRead(String(most)) });
    said.textContent = say("of the curves, in {unit}", { unit: lengthUnit(found) });
  }
  async function readAgain() {
    const wanted = curves.value.trim() ? typedNumber(curves.value) : undefined;
    if (wanted !== undefined && !(wanted > 0)) {
      problem.say(
        say("The distance of the edges from the curves must be a number above 0, in {unit}, not “{typed}”", {
          unit: lengthUnit(found),
          typed: curves.value.trim(),
        }),
      );
      return curves.focus();
    }
    const mine = ++readings;
    const again = await readShapes(text, wanted ?? 0);
    if (mine !== readings) return; // a later reading counts
    problem.say(again.problem);
    if (again.problem) return curves.focus();
    found = again;
    tolerance = wanted ?? 0;
    fill();
    told.textContent = translated("The curves are flattened again. The list shows the new numbers of vertices.");
  }
  connectKeys(list);
  fill();
  if (tolerance) curves.value = asRead(String(tolerance));
  const table = button("All in a table …", {
    onclick: () => {
      root.close();
      underWay(all(found, tolerance));
    },
  });
  table.hidden = found.shapes.length < 2;
  const root = await openWindow({
    name: "shapes",
    title: found.shapes.length > 1 || found.doubtful ? "Which shape?" : "Flatten curves",
    body: [
      el("div", { class: "scroll" }, el("p", {}, whatThereIs(what, found)), notes, whole, list, more, told),
      problem,
      el("footer", {}, form, table),
    ],
    focus: likely(),
  });
}

// Tab reaches only one shape; arrow keys move to the others.
function connectKeys(list) {
  list.addEventListener("focusin", ({ target }) => {
    for (const other of list.querySelectorAll("[tabindex='0']")) other.tabIndex = -1;
    target.tabIndex = 0;
  });
  list.addEventListener("keydown", (event) => {
    const all = [...list.querySelectorAll("button")];
    const at = all.indexOf(document.activeElement);
    const top = (shape) => Math.round(shape.getBoundingClientRect().top);
    const across = all.filter((shape) => top(shape) === top(all[0])).length;
    const step = {
      ArrowLeft: -1,
      ArrowRight: 1,
      ArrowUp: -across,
      ArrowDown: across,
      Home: -at,
      End: all.length - 1 - at,
    }[event.key];
    if (at < 0 || step === undefined) return;
    event.preventDefault();
    all[at + step]?.focus();
  });
}
