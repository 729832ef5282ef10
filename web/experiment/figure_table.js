// A row for each number of robots, and a column for each method.
import { methods } from "../charts/methods.js";
import { inDigits } from "../charts/numbers.js";
import { el } from "../kit/elements.js";

export function figureTable(figure) {
  const byRobots = new Map();
  figure.series.forEach(({ points }, column) =>
    points.forEach(([robots, value]) => {
      if (!byRobots.has(robots))
        byRobots.set(
          robots,
          figure.series.map(() => ""),
        );
      byRobots.get(robots)[column] = inDigits(figure, value);
    }),
  );
  const rows = [...byRobots].sort(([a], [b]) => a - b);
  return el(
    "table",
    { class: "numbers" },
    el(
      "thead",
      {},
      el(
        "tr",
        {},
        ...["robots", ...figure.series.map(({ method }) => methods[method].words)].map((name) =>
          el("th", { scope: "col" }, name),
        ),
      ),
    ),
    el(
      "tbody",
      {},
      ...rows.map(([robots, values]) =>
        el("tr", {}, el("th", { scope: "row" }, String(robots)), ...values.map((value) => el("td", {}, value))),
      ),
    ),
  );
}
