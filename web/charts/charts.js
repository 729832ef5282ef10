// Draws an experiment's figures for the program's report and the page; charts.css sets colours and text sizes.
import { axisX, axisY, dot, gridY, line, plot, pointer, ruleY, tip } from "@observablehq/plot";
import { say, translated } from "../words/words.js";
import { methods } from "./methods.js";
import { inDigits, inUnit } from "./numbers.js";

const colour = (method) => `var(--${method})`;

export function inWords(figure, method, [robots, value, polygons]) {
  const values = { method: methods[method].words, value: inDigits(figure, value), unit: figure.unit, robots, polygons };
  if (!figure.set) return say("{method}: {value} {unit} with {robots} robots", values); // of a single polygon
  return polygons === 1
    ? say("{method}: {value} {unit} with {robots} robots, 1 polygon", values)
    : say("{method}: {value} {unit} with {robots} robots, {polygons} polygons", values);
}

// `width` is in pixels. A figure is {id, title, unit, series: [{method, points: [[robots, value, polygons], …]}]}.
export function drawChart(figure, width) {
  const rows = figure.series.flatMap(({ method, points }) =>
    points.map((point) => ({
      method,
      robots: point[0],
      value: inUnit(figure, point[1]),
      label: inWords(figure, method, point),
    })),
  );
  const svg = plot({
    className: "chart",
    width,
    height: Math.round(Math.max(220, Math.min(320, width * 0.5))),
    marginLeft: 44,
    marginTop: 24,
    marginBottom: 40,
    x: {
      domain: [Math.min(2, ...rows.map(({ robots }) => robots)), Math.max(4, ...rows.map(({ robots }) => robots))],
      inset: 6,
    },
    y: { domain: span(figure, rows), nice: true },
    marks: [
      gridY({ ticks: 5, stroke: "var(--line)", strokeOpacity: 1 }),
      axisX({
        label: translated("robots"),
        tickFormat: "d",
        ticks: width / 70,
        tickSize: 4,
        labelAnchor: "center",
        labelArrow: "none",
        fontSize: 12,
      }),
      axisY({ label: figure.unit, ticks: 5, tickSize: 0, labelArrow: "none", fontSize: 12 }),
      ruleY(figure.unit === "%" && span(figure, rows)[0] > 0 ? [] : [0], { stroke: "var(--second)" }),
      ...figure.series.map(({ method }) =>
        line(
          rows.filter((row) => row.method === method),
          {
            x: "robots",
            y: "value",
            stroke: colour(method),
            strokeWidth: 1.75,
            strokeDasharray: methods[method].dashes,
            className: `line-${method}`,
          },
        ),
      ),
      ...figure.series.map(({ method }) =>
        dot(
          rows.filter((row) => row.method === method),
          {
            x: "robots",
            y: "value",
            stroke: colour(method),
            fill: method === "random" ? "none" : colour(method),
            symbol: methods[method].sign,
            r: width < 420 ? 2 : 2.5,
            ariaLabel: "label",
            className: `dots-${method}`,
          },
        ),
      ),
      tip(
        rows,
        pointer({
          x: "robots",
          y: "value",
          title: "label",
          fontSize: 12,
          lineWidth: 22,
          fill: "var(--panel)",
          stroke: "var(--line)",
          textPadding: 8,
        }),
      ),
    ],
  });
  // A page's content security policy refuses Plot's own style sheet; charts.css has the same rules.
  svg.querySelector("style")?.remove();
  svg.setAttribute("aria-hidden", "true"); // read out as one picture, see follow()
  return svg;
}

// A greatest share is never below a half, so its axis begins at 50 %; every other begins at 0.
function span(figure, rows) {
  const values = rows.map(({ value }) => value);
  if (values.length === 0) return [0, 1];
  const most = Math.max(...values);
  if (figure.column === "max_share_mean") return [50, Math.max(most, 51)];
  if (/^(coverage|form_closure)(_mean)?$/.test(figure.column)) return [0, 100];
  return [0, most > 0 ? most : 1];
}

export function legend(figures) {
  const used = Object.keys(methods).filter((method) =>
    figures.some(({ series }) => series.some((one) => one.method === method)),
  );
  const list = document.createElement("ul");
  list.className = "legend";
  for (const method of used) {
    const key = plot({
      className: "key",
      width: 34,
      height: 14,
      margin: 0,
      axis: null,
      x: { domain: [0, 1] },
      y: { domain: [0, 1] },
      marks: [
        line(
          [
            [0.04, 0.5],
            [0.96, 0.5],
          ],
          { stroke: colour(method), strokeWidth: 1.75, strokeDasharray: methods[method].dashes },
        ),
        dot([[0.5, 0.5]], {
          stroke: colour(method),
          fill: method === "random" ? "none" : colour(method),
          symbol: methods[method].sign,
          r: 3,
        }),
      ],
    });
    key.querySelector("style")?.remove();
    key.setAttribute("aria-hidden", "true");
    const item = document.createElement("li");
    item.append(key, translated(methods[method].words));
    list.append(item);
  }
  return list;
}

// Draws a figure again whenever its element's width changes.
export function follow(element, figure) {
  element.setAttribute("role", "img");
  const { title, sentence } = figure;
  element.setAttribute("aria-label", say("Chart: {title}, by number of robots. {sentence}", { title, sentence }));
  let drawn = 0;
  const draw = () => {
    const width = Math.floor(element.clientWidth);
    if (width === drawn || width < 40) return;
    drawn = width;
    element.replaceChildren(drawChart(figure, width));
  };
  draw();
  const observer = new ResizeObserver(draw);
  observer.observe(element);
  return () => observer.disconnect();
}
