import { ofWindows, shared } from "./icons.js";
import { readings, withPoint } from "../words/numbers.js";
import { translated } from "../words/words.js";

const svgSpace = "http://www.w3.org/2000/svg";

const readable = ["alt", "aria-label", "placeholder", "title"];

// Attributes `on…` are event handlers, others are as in HTML; false and undefined leave an attribute out. Texts that
// people read are translated.
export function el(name, attributes = {}, ...children) {
  return fill(document.createElement(name), attributes, children);
}

export function svgEl(name, attributes = {}, ...children) {
  return fill(document.createElementNS(svgSpace, name), attributes, children);
}

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (readable.includes(name)) element.setAttribute(name, translated(value));
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.map((child) => (typeof child === "string" ? translated(child) : child)));
  return element;
}

const icons = { ...shared, ...ofWindows };

export function icon(name) {
  return svgEl(
    "svg",
    { viewBox: "0 0 20 20", class: "icon", "aria-hidden": "true" },
    svgEl("path", { d: icons[name] }),
  );
}

// Attributes are as for el().
export function button(name, attributes = {}, picture) {
  return el("button", { type: "button", class: "button", ...attributes }, ...(picture ? [icon(picture)] : []), name);
}

export function download(blob, name) {
  const url = URL.createObjectURL(blob);
  el("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60000); // the browser may ask before it saves
}

// A PNG, `scale` times as large.
export async function rasterise(svg, scale) {
  const url = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = el("canvas", { width: image.naturalWidth * scale, height: image.naturalHeight * scale });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((done, fail) => {
      canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error("the picture is too large"))), "image/png");
    });
  } finally {
    URL.revokeObjectURL(url);
  }
}

// "82 %" stays on one line.
export const unbroken = (text) => text.replace(/(?<=\d) (?=%)/g, "\u00a0");

// A paragraph for each line; attributes are as for el().
export const paragraphs = (text, attributes = {}) =>
  text ? text.split("\n").map((line) => el("p", attributes, unbroken(translated(line)))) : [];

// NaN for a text that is no number, or may be two (readings()).
export function typedNumber(text) {
  const typed = text.trim();
  return typed && !readings(typed) ? Number(withPoint(typed)) : NaN;
}
