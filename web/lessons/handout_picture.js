// Positions are on the paper (wasm/modules/handout_paper.h).
import { el, svgEl } from "../kit/elements.js";
import { pathOf } from "../kit/fit.js";

// The class in dialogs.css for each kind of figure; other kinds are drawn as an accent. A line also has a name for the
// list of lines, since paper has no pointer to identify it.
const looks = {
  base: ["base", "the lifting base H"],
  base_before: ["base-before", "the previous lifting base"],
  candidate: ["candidate", "a candidate"],
  even_chord: ["candidate", "an even chord"],
  former: ["candidate", "the previous place of a team"],
  team: ["chord", "a team"],
  chord: ["accent", "a chord through C"],
  ray: ["ray", "a ray through C"],
  radial_edge: ["radial", "an edge in line with C"],
  edge: ["edge", "an edge of the pair"],
  section: ["section", "its section, where chords may end"],
  reflected: ["reflected", "the image of an edge after half a turn about C"],
  section_end: ["end", "a chord at the end of the sections"],
  range_end: ["end", "a chord at the end of the range"],
  bisecting: ["bisecting", "the chord that C bisects"],
  chosen: ["chosen", "the chosen chord"],
  arm_before: ["arm-before", "an arm to the edge of H"],
  arm_after: ["arm-after", "an arm to the new edge"],
  normal: ["normal", "the normal line of a contact"],
  lever: ["chosen", "a lever about C"],
  hole: ["thin", "a hole"],
  hole_part: ["thin"],
  cargo: ["contact"],
  old_centre: ["contact"],
  side: ["side", "two robots that lift together"],
  clockwise: ["clockwise", "points about which it can turn clockwise"],
  counterclockwise: ["counterclockwise", "points about which it can turn counter-clockwise"],
  mirrored: ["reflected", "the object after half a turn about M"],
  gain_part: ["gain", "what a candidate adds to H"],
  gain_triangle: ["gain"],
  gain_circle: ["gain"],
  range: ["gain"],
  triangle: ["thin"],
  body: ["thin"],
  hand: ["thin"],
  unusable: ["radial"],
  contact: ["contact"],
  stand: ["contact"],
  way: ["way", "where a robot moves"],
  translation: ["way", "a way to slide"],
  arm: ["arrow"],
  sum: ["accent"],
};
const lookOf = (kind) => (looks[kind] ?? ["accent"])[0];
const arrows = ["translation", "way", "sum", "arm"];
const round = ["gain_circle", "body"];

function shape(points, look) {
  if (points.length > 2)
    return svgEl("polygon", { points: points.map((point) => point.join(" ")).join(" "), class: look });
  const [[x1, y1], [x2, y2] = []] = points;
  if (points.length < 2) return svgEl("circle", { cx: x1, cy: y1, r: 4, class: look });
  return svgEl("line", { x1, y1, x2, y2, class: look });
}

function arrow([x1, y1], [x2, y2], look) {
  const long = Math.hypot(x2 - x1, y2 - y1) || 1,
    [u, v] = [(x2 - x1) / long, (y2 - y1) / long];
  const side = (to) => `${x2 - 7 * u + to * 3.5 * v} ${y2 - 7 * v - to * 3.5 * u}`;
  return [
    svgEl("line", { x1, y1, x2, y2, class: look }),
    svgEl("polygon", { points: `${x2} ${y2} ${side(1)} ${side(-1)}`, class: `${look} head` }),
  ];
}

function drawnFigure({ kind, points, value }) {
  const look = lookOf(kind);
  if (round.includes(kind)) return [svgEl("circle", { cx: points[0][0], cy: points[0][1], r: value, class: look })];
  if (!arrows.includes(kind) || points.length < 2) return [shape(points, look)];
  if (points.length === 2) return arrow(points[0], points[1], look);
  return points.flatMap((point, i) => arrow(point, points[(i + 1) % points.length], look));
}

// A robot, or its former place.
const numbered = ([cx, cy], number, disc, look) => [
  svgEl("circle", { cx, cy, r: disc, class: look }),
  svgEl("text", { x: cx, y: cy + 3.5, class: `number ${look}-number` }, number),
];

// Figures in the object, so that holes show the paper. The parts of an object with holes touch themselves, so they have
// no outline.
const inObject = { base: "base", gain_triangle: "gain", gain_part: "gain filled" };

// The holes over the areas in the object, and the lines of these areas over the holes.
function drawnHoles(holes, base, areas) {
  if (holes.length === 0) return [];
  const filled = areas.map(({ kind, points }) => shape(points, inObject[kind]));
  const lines = areas.filter(({ kind }) => kind !== "gain_part").map(({ kind, points }) => [points, inObject[kind]]);
  return [
    ...filled,
    svgEl("path", { d: pathOf(holes), class: "hole" }),
    ...(base.length > 1 ? [[base, "base"], ...lines] : lines).map(([points, look]) => shape(points, `${look} bare`)),
  ];
}

function drawnCargo(cargo, [x1, y1], [x2, y2]) {
  if (cargo.length === 0) return [];
  return [
    ...cargo.map(({ at: [cx, cy], radius }) => svgEl("circle", { cx, cy, r: radius, class: "cargo" })),
    svgEl("line", { x1, y1, x2, y2, class: "thin" }),
    svgEl("circle", { cx: x1, cy: y1, r: 3, class: "own-centre" }),
  ];
}

// The paper clips lines and regions that extend beyond it.
export function picture({ width, height, disc, polygon, holes, cargo, own_centre: own, centre }, step) {
  const [cx, cy] = centre;
  const below = step.figures.filter(({ kind }) => holes.length > 0 && kind in inObject);
  const figures = step.figures.filter((figure) => !["robot", "left"].includes(figure.kind) && !below.includes(figure));
  return svgEl(
    "svg",
    { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": step.caption, class: "paper" },
    svgEl("polygon", { points: polygon.map((point) => point.join(" ")).join(" "), class: "object" }),
    ...(step.base.length > 1 ? [shape(step.base, "base")] : []),
    ...drawnHoles(holes, step.base, below),
    ...step.candidates.map((chord) => shape(chord, "candidate")),
    ...step.teams.map((ends) => shape(ends, "chord")),
    ...figures.flatMap(drawnFigure),
    ...drawnCargo(cargo, own, centre),
    svgEl("circle", { cx, cy, r: 3.5, class: "centre" }),
    ...step.figures
      .filter(({ kind }) => kind === "left")
      .flatMap(({ points: [at], number }) => numbered(at, number, disc, "left")),
    ...step.robots.flatMap(({ at, number }) => numbered(at, number, disc, "robot")),
    ...step.words.map(({ text, at: [x, y] }) => svgEl("text", { x, y: y + 3.5, class: "words" }, text)),
  );
}

export function legend({ steps }) {
  const kinds = new Set(
    steps.flatMap((step) => [
      ...(step.base.length > 1 ? ["base"] : []),
      ...(step.candidates.length ? ["candidate"] : []),
      ...(step.teams.length ? ["team"] : []),
      ...step.figures.map(({ kind }) => kind),
    ]),
  );
  // Balanced robots do not form teams of two: such a line connects a robot to C.
  const balanced = !steps.some((step) => step.teams.length);
  const named = Object.entries({ ...looks, ...(balanced && { team: ["chord", "from a robot to C"] }) }).filter(
    ([kind, [, name]]) => name && kinds.has(kind),
  );
  if (!named.length) return [];
  const sample = (kind, look) =>
    svgEl(
      "svg",
      { viewBox: "0 0 34 12", class: "paper line-sample", "aria-hidden": "true" },
      ...(arrows.includes(kind)
        ? arrow([2, 6], [32, 6], look)
        : [svgEl("line", { x1: 2, y1: 6, x2: 32, y2: 6, class: look })]),
    );
  return [
    el(
      "ul",
      { class: "paper-legend", "aria-label": "The lines in the pictures" },
      ...named.map(([kind, [look, name]]) => el("li", {}, sample(kind, look), name)),
    ),
  ];
}
