// The text of an SVG file as a tree of elements, by the browser's own XML parser.

// Its message is one sentence for the person whose file is refused.
export class Refusal extends Error {}

// Browsers know elements by their namespace. Elements of a namespace that no browser knows are only names and
// attributes: no style is applied, nothing is loaded or run, and the page's security policy has nothing to report.
const known = /http:\/\/www\.w3\.org\/(?=2000\/svg|1999\/xhtml|1998\/Math)/g;
const withoutMeaning = (text) => text.replace(known, "urn:inert:");

// What may come before the root element; the parser below reads only elements.
const beforeRoot = /\s+|<\?[^]*?\?>|<!--[^]*?-->|<!DOCTYPE[^<>[]*>/y;

function withoutProlog(text) {
  let start = 0;
  for (beforeRoot.lastIndex = 0; beforeRoot.test(text);) start = beforeRoot.lastIndex;
  const root = text.slice(start);
  if (/^<!DOCTYPE[^<>[]*\[/.test(root)) throw new Refusal("The DOCTYPE of the SVG has definitions, which evenlift does not read");
  return root;
}

// The root element. The text is parsed as the content of an element, and not by DOMParser: where it is wrong, Chromium's
// DOMParser makes an HTML element with a style that describes the error, which the page's security policy blocks and
// reports.
export function parseSvg(text) {
  const content = withoutMeaning(withoutProlog(text));
  const holder = document.implementation.createDocument(null, "holder").documentElement;
  // HTML has this prefix without a declaration, and SVG is often copied from there.
  holder.setAttributeNS("http://www.w3.org/2000/xmlns/", "xmlns:xlink", "http://www.w3.org/1999/xlink");
  const malformed = new Refusal("The SVG is not well-formed XML");
  try {
    holder.innerHTML = content;
  } catch {
    throw malformed;
  }
  const isText = (node) => node instanceof Text && node.data.trim() !== "";
  if (holder.children.length !== 1 || Array.prototype.some.call(holder.childNodes, isText)) throw malformed;
  const [root] = holder.children;
  if (root.localName !== "svg") throw new Refusal(`The XML is no SVG, its element is <${root.tagName}>`);
  return root;
}
