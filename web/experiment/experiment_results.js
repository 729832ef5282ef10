// The results are described in evenlift/experiment/outputs.h.
import { methods } from "../charts/methods.js";
import { el } from "../kit/elements.js";
import { figureTable } from "./figure_table.js";
import { number } from "../words/numbers.js";
import { say, translated } from "../words/words.js";

const wide = (label, content) =>
  el("div", { class: "wide", tabindex: "0", role: "region", "aria-label": label }, content);

function refused({ refused: all }) {
  if (all.length === 0) return [];
  return [
    el(
      "div",
      { class: "problem", role: "status" },
      all.length === 1
        ? "1 polygon could not be read and was left out:"
        : say("{number} polygons could not be read and were left out:", { number: number(all.length) }),
      el("ul", {}, ...all.map(({ polygon, problem }) => el("li", {}, `${polygon}: ${translated(problem)}`))),
    ),
  ];
}

function figure(made, place) {
  return el(
    "figure",
    {},
    el("h3", {}, `${translated(made.title)} (${made.unit})`),
    place,
    el("figcaption", {}, made.sentence),
    el(
      "details",
      {},
      el("summary", {}, "Numbers"),
      wide(say("Numbers: {title}", { title: made.title }), figureTable(made)),
    ),
  );
}

function claims({ claims: { sets, rows } }) {
  if (rows.length === 0) return [];
  const head = (name) => el("th", { scope: "col" }, name);
  return [
    el(
      "details",
      { class: "claims" },
      el("summary", {}, "Against the thesis: the statements of its chapter 5, and these polygons"),
      wide(
        "Against the thesis",
        el(
          "table",
          {},
          el(
            "thead",
            {},
            el("tr", {}, ...["Section", "What", "The thesis", ...(sets.length > 1 ? sets : ["Here"])].map(head)),
          ),
          el(
            "tbody",
            {},
            ...rows.map(({ section, what, thesis, ours }) =>
              el(
                "tr",
                {},
                el("td", {}, section),
                el("th", { scope: "row" }, what),
                el("td", {}, thesis),
                ...ours.map((cell) => el("td", {}, cell)),
              ),
            ),
          ),
        ),
      ),
    ),
  ];
}

function fewRobotsTable(what, rows) {
  const head = (name) => el("th", { scope: "col" }, name);
  return el(
    "figure",
    {},
    el("h3", {}, what),
    wide(
      what,
      el(
        "table",
        { class: "numbers" },
        el("thead", {}, el("tr", {}, ...["robots", ...Object.values(methods).map(({ words }) => words)].map(head))),
        el(
          "tbody",
          {},
          ...rows.map(({ robots, cells }) =>
            el("tr", {}, el("th", { scope: "row" }, String(robots)), ...cells.map((cell) => el("td", {}, cell))),
          ),
        ),
      ),
    ),
  );
}

function fewRobots({ few_robots: sets }) {
  return sets.map(({ set, rows }) =>
    el(
      "details",
      { class: "few-robots" },
      el(
        "summary",
        {},
        (sets.length > 1 ? `${set}: ` : "") +
          translated("3 to 12 robots in numbers, including odd numbers of balanced robots"),
      ),
      el(
        "div",
        { class: "figures" },
        ...[...new Set(rows.map(({ what }) => what))].map((what) =>
          fewRobotsTable(
            what,
            rows.filter((row) => row.what === what),
          ),
        ),
      ),
    ),
  );
}

// Returns functions that end the charts' updates.
export async function showResults(into, outputs, caption) {
  const places = outputs.figures.map(({ id }) => el("div", { class: "plot", "data-figure": id }));
  into.replaceChildren(
    el("p", { class: "second" }, caption),
    ...refused(outputs),
    el("div", { class: "figures" }, ...outputs.figures.map((made, at) => figure(made, places[at]))),
    ...fewRobots(outputs),
    ...claims(outputs),
  );
  const charts = await import("./charts.js");
  if (charts.missing) {
    into.prepend(
      el(
        "p",
        { class: "problem" },
        "The charts are missing: this page was built without the library that draws them. Their numbers are below.",
      ),
    );
    return [];
  }
  return outputs.figures.flatMap((made, at) => {
    if (!places[at].isConnected) return [];
    places[at].before(charts.legend([made]));
    return [charts.follow(places[at], made)];
  });
}
