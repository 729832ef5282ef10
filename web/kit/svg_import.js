// Converts an SVG picture of one polygon to text in the thesis's format. What it does not understand it refuses with a
// sentence. It reads numbers itself, as the browser's lists of points and transforms hold 32-bit numbers.
import { Refusal, parseSvg } from "./svg_document.js";

const numberAt = /[\s,]*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)/iy;

// The numbers of a list, with SVG's separators. The list begins after `before` characters of what the message names.
function numbers(text, what, before = 0) {
  const found = [];
  numberAt.lastIndex = 0;
  for (let end = 0; ; end = numberAt.lastIndex) {
    const match = numberAt.exec(text);
    if (match) {
      found.push(Number(match[1]));
      continue;
    }
    const wrong = text.slice(end).search(/[^\s,]/);
    if (wrong < 0) return found;
    throw new Refusal(`${what}, character ${before + end + wrong + 1}: not a number`);
  }
}

function ofPolygon(shape) {
  const all = numbers(shape.getAttribute("points") ?? "", "The SVG's polygon");
  if (all.length % 2) throw new Refusal("The SVG's polygon: the last point has no y");
  return Array.from({ length: all.length / 2 }, (_, i) => [all[2 * i], all[2 * i + 1]]);
}

// How many numbers each command of a path takes.
const takes = { M: 2, L: 2, H: 1, V: 1, Z: 0 };

function ofPath(shape) {
  const text = shape.getAttribute("d") ?? "";
  const points = [];
  let x = 0, y = 0, closed = false;
  for (const { 0: part, 1: letter, index } of text.matchAll(/([a-df-z])[^a-df-z]*|[^\s,]+?/gi)) {
    const where = `The SVG's path, character ${index + 1}`;
    const command = letter?.toUpperCase();
    if (/[CSQTA]/.test(command)) throw new Refusal(`${where}: it is curved there (${letter}), and evenlift takes straight edges only`);
    if (!(command in takes) || (points.length === 0 && command !== "M")) throw new Refusal(`${where}: no command that belongs there`);
    if (command !== "Z" && (closed || (command === "M" && points.length > 0))) throw new Refusal(`${where}: a second outline begins, and evenlift takes one without holes`);
    closed = command === "Z";
    const all = numbers(part.slice(1), "The SVG's path", index + 1);
    const each = takes[command];
    if (each ? all.length === 0 || all.length % each : all.length > 0) throw new Refusal(`${where}: ${letter} does not take ${all.length} numbers`);
    const relative = letter !== command;
    for (let i = 0; i < all.length; i += each) {
      if (command !== "V") x = (relative ? x : 0) + all[i];
      if (command !== "H") y = (relative ? y : 0) + all[i + each - 1];
      points.push([x, y]);
    }
  }
  return points;
}

// The functions of a transform: how many numbers each takes, and what it does to a matrix.
const functions = new Map([
  ["matrix", { counts: [6], apply: (matrix, ...values) => matrix.multiplySelf(new DOMMatrix(values)) }],
  ["translate", { counts: [1, 2], apply: (matrix, x, y = 0) => matrix.translateSelf(x, y) }],
  ["scale", { counts: [1, 2], apply: (matrix, x, y = x) => matrix.scaleSelf(x, y) }],
  ["rotate", { counts: [1, 3], apply: (matrix, degrees, x = 0, y = 0) => matrix.translateSelf(x, y).rotateSelf(degrees).translateSelf(-x, -y) }],
  ["skewX", { counts: [1], apply: (matrix, degrees) => matrix.skewXSelf(degrees) }],
  ["skewY", { counts: [1], apply: (matrix, degrees) => matrix.skewYSelf(degrees) }],
]);

// Multiplies the matrix with that of an element's `transform`.
function applyTransform(matrix, element) {
  if (/transform|translate|scale|rotate/.test(element.getAttribute("style"))) throw new Refusal("The SVG moves its shape by a style, which is not understood; a transform attribute would be");
  const text = (element.getAttribute("transform") ?? "").trimEnd();
  const call = /[\s,]*([a-z]+)\s*\(([^)]*)\)/iy;
  for (let at = 0; at < text.length; at = call.lastIndex) {
    call.lastIndex = at;
    const [whole, name, list] = call.exec(text) ?? [text.slice(at)];
    const { counts, apply } = functions.get(name) ?? { counts: [] };
    const values = counts.length ? numbers(list, "The SVG's transform", at + whole.indexOf("(") + 1) : [];
    if (!counts.includes(values.length)) throw new Refusal(`The SVG's transform ${whole.trim().slice(0, 60)} is not understood`);
    apply(matrix, ...values);
  }
}

// The content of these elements is not drawn in its own place.
const unseen = new Set(["defs", "clipPath", "mask", "pattern", "marker", "symbol"]);

function onlyShape(root) {
  const seen = (element) => unseen.has(element.localName) ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT;
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_ELEMENT, seen);
  let shape;
  for (let element; (element = walker.nextNode());) {
    if (element.localName !== "polygon" && element.localName !== "path") continue;
    if (shape) throw new Refusal("The SVG has more than one shape, and evenlift takes one polygon");
    shape = element;
  }
  return shape;
}

function polygonOf(root) {
  for (const style of root.querySelectorAll("style")) {
    if (/transform|translate:|scale:|rotate:/.test(style.textContent)) throw new Refusal("The SVG's style sheet moves shapes, which is not understood; a transform attribute would be");
  }
  const shape = onlyShape(root);
  if (!shape) throw new Refusal("The SVG has no <polygon> and no <path> to read");
  if (shape.parentElement.closest("svg") !== root) throw new Refusal("The SVG's shape is in an <svg> of its own inside it, which is not understood");
  const points = shape.localName === "path" ? ofPath(shape) : ofPolygon(shape);
  const last = points.at(-1);
  if (points.length > 1 && last[0] === points[0][0] && last[1] === points[0][1]) points.pop();

  const matrix = new DOMMatrix();
  const outside = [];
  for (let element = shape; element !== root; element = element.parentElement) outside.unshift(element);
  for (const element of outside) applyTransform(matrix, element);
  const { a, b, c, d, e, f } = matrix;
  // In SVG y points down, here up.
  return points.map(([x, y]) => [a * x + c * y + e, 0 - (b * x + d * y + f)]);
}

// Returns { text }, or { problem }: a sentence that says what is wrong.
export function svgToText(svg) {
  try {
    return { text: polygonOf(parseSvg(svg)).map(([x, y]) => `(${x},${y})\n`).join("") };
  } catch (error) {
    if (error instanceof Refusal) return { problem: error.message };
    throw error;
  }
}
