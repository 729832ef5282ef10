// Reads XML element by element, without making a document of it: what a browser makes of a file applies the page's
// security policy to its styles, and words its errors as it likes. Texts are passed over; entities are not defined.

const name = /[^\s=<>"'/!?]+/y;
const attribute = /\s+([^\s=<>"'/]+)\s*=\s*(["'])/y;
const tagEnd = /\s*(\/?)>/y;
const passedOver = [["<!--", "-->"], ["<![CDATA[", "]]>"], ["<?", "?>"]];
const characters = { lt: "<", gt: ">", amp: "&", quot: '"', apos: "'" };

function decoded(value) {
  return value.replace(/&(#x?)?(\w+);/g, (whole, mark, code) => (mark ? String.fromCodePoint(parseInt(code, mark === "#" ? 10 : 16) & 0xFFFF) : characters[code] ?? whole));
}

// Calls visit({name, attributes, parent}, end) for each element when it ends; `end` gives the text since it began.
// Names are without their prefix.
export function readXml(text, visit) {
  let at = 0;
  let tag = 0;  // where the present one begins
  let open = null;
  const fail = (why = "it is not well-formed XML") => {
    const before = text.slice(0, tag).split("\n");
    throw new Error(`Line ${before.length}, column ${before.at(-1).length + 1}: ${why}`);
  };
  const match = (pattern) => {
    pattern.lastIndex = at;
    const found = pattern.exec(text);
    if (found) at = pattern.lastIndex;
    return found;
  };
  const goPast = (mark, from) => {
    const end = text.indexOf(mark, from);
    if (end < 0) fail();
    at = end + mark.length;
  };
  const local = (whole) => whole.slice(whole.indexOf(":") + 1);
  const closed = () => {
    visit(open, () => text.slice(open.start, at));
    open = open.parent;
  };
  for (;;) {
    const next = text.indexOf("<", at);
    if (next < 0) break;
    at = tag = next;
    const mark = passedOver.find(([begin]) => text.startsWith(begin, at));
    if (mark) {
      goPast(mark[1], at + mark[0].length);
    } else if (text.startsWith("<!DOCTYPE", at)) {
      const end = text.indexOf(">", at);
      if (text.slice(at, end).includes("[")) fail("definitions in the DOCTYPE are not read");
      goPast(">", at);
    } else if (text.startsWith("</", at)) {
      at += 2;
      if (match(name)?.[0] !== open?.whole || !match(tagEnd)) fail();
      closed();
    } else {
      at += 1;
      const whole = match(name)?.[0] ?? fail();
      const attributes = {};
      for (let found; (found = match(attribute));) {
        const from = at;
        goPast(found[2], from);
        attributes[local(found[1])] = decoded(text.slice(from, at - 1));
      }
      const end = match(tagEnd) ?? fail();
      open = { whole, name: local(whole), attributes, parent: open, start: at };
      if (!open.parent && open.name !== "svg") throw new Error(`The XML is no SVG, its element is <${whole}>`);
      if (end[1]) closed();
    }
  }
  tag = text.length;
  if (open) fail();
}
