// Elements and downloads for the page's own windows.
const svgSpace = "http://www.w3.org/2000/svg";

// Makes an element: `on…` are handlers, other attributes as in HTML; false and undefined leave one out.
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
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

// The strokes of a picture of 16 by 16.
const icons = {
  close: "M4 4l8 8M12 4l-8 8",
  plus: "M8 3v10M3 8h10",
  copy: "M6 6h7v7H6zM10 6V3H3v7h3",
  done: "M3 8.5l3.5 3.5L13 5",
  qr: "M3 3h4v4H3zM9 3h4v4H9zM3 9h4v4H3zM9 9h1M13 9v1M10 11v2M13 13h-1",
  file: "M4 2.5h5l3 3v8H4zM9 2.5v3h3",
  save: "M8 2.5v7M5 7l3 3 3-3M3 13.5h10",
};

export function icon(name) {
  return svgEl("svg", { viewBox: "0 0 16 16", class: "icon", "aria-hidden": "true" }, svgEl("path", { d: icons[name] }));
}

// A button with a name; attributes as of el().
export function button(name, attributes = {}, picture) {
  return el("button", { type: "button", class: "button", ...attributes }, ...(picture ? [icon(picture)] : []), name);
}

export function download(blob, name) {
  const url = URL.createObjectURL(blob);
  el("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);  // the browser may ask before it saves
}

// A picture of SVG, `scale` times as large, as a PNG.
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

export const number = (value) => value.toLocaleString("en");

export function lowered(sentence) {
  return sentence.charAt(0).toLowerCase() + sentence.slice(1);
}
