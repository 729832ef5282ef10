// An SVG picture of one polygon as text in the thesis's format. What cannot be understood is refused with a sentence: an
// Error whose message names the place.
import { readXml } from "./xml.js";

const numberAt = /[\s,]*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)/iy;

// The numbers of a list, as SVG separates them.
function numbers(text, where) {
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
    throw new Error(`${where}, character ${end + wrong + 1}: not a number`);
  }
}

function ofPolygon(shape) {
  const all = numbers(shape.attributes.points ?? "", "The SVG's polygon");
  if (all.length % 2) throw new Error("The SVG's polygon: the last point has no y");
  return Array.from({ length: all.length / 2 }, (_, i) => [all[2 * i], all[2 * i + 1]]);
}

const takes = { M: 2, L: 2, H: 1, V: 1, Z: 0 };

function ofPath(shape) {
  const text = shape.attributes.d ?? "";
  const points = [];
  let x = 0, y = 0, closed = false;
  for (const { 0: part, 1: letter, index } of text.matchAll(/([a-df-z])[^a-df-z]*|[^\s,]+?/gi)) {
    const where = `The SVG's path, character ${index + 1}`;
    const command = letter?.toUpperCase();
    if (/[CSQTA]/.test(command)) throw new Error(`${where}: it is curved there (${letter}), and evenlift takes straight edges only`);
    if (!(command in takes) || (points.length === 0 && command !== "M")) throw new Error(`${where}: no command that belongs there`);
    if (command !== "Z" && (closed || (command === "M" && points.length > 0))) throw new Error(`${where}: a second outline begins, and evenlift takes one without holes`);
    closed = command === "Z";
    const all = numbers(part.slice(1), where);
    const each = takes[command];
    if (each ? all.length === 0 || all.length % each : all.length > 0) throw new Error(`${where}: ${letter} does not take ${all.length} numbers`);
    const relative = letter !== command;
    for (let i = 0; i < all.length; i += each) {
      if (command !== "V") x = (relative ? x : 0) + all[i];
      if (command !== "H") y = (relative ? y : 0) + all[i + each - 1];
      points.push([x, y]);
    }
  }
  return points;
}

// The six numbers of a matrix; a point (x, y) goes to (a x + c y + e, b x + d y + f).
function matrixOf(name, v) {
  const radians = (degrees) => (degrees * Math.PI) / 180;
  const counts = { matrix: [6], translate: [1, 2], scale: [1, 2], rotate: [1, 3], skewX: [1], skewY: [1] };
  if (!counts[name]?.includes(v.length)) throw new Error(`The SVG's transform ${name}(${v.join(" ")}) is not understood`);
  switch (name) {
    case "matrix": return v;
    case "translate": return [1, 0, 0, 1, v[0], v[1] ?? 0];
    case "scale": return [v[0], 0, 0, v[1] ?? v[0], 0, 0];
    case "skewX": return [1, 0, Math.tan(radians(v[0])), 1, 0, 0];
    case "skewY": return [1, Math.tan(radians(v[0])), 0, 1, 0, 0];
    default: {
      // Quarter turns are exact.
      const [cos, sin] = v[0] % 90 ? [Math.cos(radians(v[0])), Math.sin(radians(v[0]))]
        : [[1, 0], [0, 1], [-1, 0], [0, -1]][(((v[0] / 90) % 4) + 4) % 4];
      const [x, y] = [v[1] ?? 0, v[2] ?? 0];
      return [cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y];
    }
  }
}

// What the `transform` of an element does to the points inside it.
function transformed(points, element) {
  const text = element.attributes.transform ?? "";
  if (/transform|translate|scale|rotate/.test(element.attributes.style)) throw new Error("The SVG moves its shape by a style, which is not understood; a transform attribute would be");
  const parts = [...text.matchAll(/([a-z]+)\s*\(([^)]*)\)/gi)];
  const rest = text.replace(/([a-z]+)\s*\(([^)]*)\)/gi, "");
  if (/[^\s,]/.test(rest)) throw new Error(`The SVG's transform “${text.slice(0, 60)}” is not understood`);
  return parts.reduceRight((moved, [, name, list]) => {
    const [a, b, c, d, e, f] = matrixOf(name, numbers(list, "The SVG's transform"));
    return moved.map(([x, y]) => [a * x + c * y + e, b * x + d * y + f]);
  }, points);
}

const unseen = new Set(["defs", "clipPath", "mask", "pattern", "marker", "symbol"]);

// An element and all that it is in.
function ancestors(element) {
  const all = [];
  for (; element; element = element.parent) all.push(element);
  return all;
}

export function svgToText(text) {
  const shapes = [];
  readXml(text, (element, content) => {
    if (element.name === "polygon" || element.name === "path") {
      if (!ancestors(element.parent).some(({ name }) => unseen.has(name))) shapes.push(element);
      if (shapes.length > 1) throw new Error("The SVG has more than one shape, and evenlift takes one polygon");
    } else if (element.name === "style" && /transform|translate:|scale:|rotate:/.test(content())) {
      throw new Error("The SVG's style sheet moves shapes, which is not understood; a transform attribute would be");
    }
  });
  const [shape] = shapes;
  if (!shape) throw new Error("The SVG has no <polygon> and no <path> to read");
  let points = shape.name === "path" ? ofPath(shape) : ofPolygon(shape);
  for (const element of ancestors(shape)) {
    if (element.parent) points = transformed(points, element);
    if (element.parent && element.name === "svg") throw new Error("The SVG's shape is in an <svg> of its own inside it, which is not understood");
  }
  const last = points.at(-1);
  if (points.length > 1 && last[0] === points[0][0] && last[1] === points[0][1]) points.pop();
  // y is down in a picture and up here.
  return points.map(([x, y]) => `(${x},${0 - y})\n`).join("");
}
