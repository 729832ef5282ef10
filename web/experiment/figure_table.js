// The numbers of a figure of an experiment as a table: a row for each number of robots, a column for each method.
import { el } from "../kit/elements.js";

const shown = ({ unit }, value) => (unit === "%" ? (100 * value).toFixed(1) : value.toFixed(2));

export function figureTable(figure) {
  const byRobots = new Map();
  figure.series.forEach(({ points }, column) => points.forEach(([robots, value]) => {
    if (!byRobots.has(robots)) byRobots.set(robots, figure.series.map(() => ""));
    byRobots.get(robots)[column] = shown(figure, value);
  }));
  const rows = [...byRobots].sort(([a], [b]) => a - b);
  return el("table", { class: "numbers" },
    el("thead", {}, el("tr", {}, ...["robots", ...figure.series.map(({ method }) => method)].map((name) => el("th", { scope: "col" }, name)))),
    el("tbody", {}, ...rows.map(([robots, values]) => el("tr", {}, el("th", { scope: "row" }, String(robots)), ...values.map((value) => el("td", {}, value))))));
}
