// Numbers as people type them, and as the program reads them (core/include/evenlift/settings_text.h).

// What a control shows, ready to be typed over: "437 kg" becomes "437", and "(12.4, −3)" "12.4, -3".
export function plainValue(shown) {
  const text = shown.replaceAll("−", "-").replaceAll("\u00A0", " ").trim();
  if (text === "–") return "";  // nothing yet
  if (text.startsWith("(")) return text.slice(1, -1);
  return /^[-\d.]/.test(text) ? text.split(" ")[0].replace(/°$/, "") : text;
}

const number = String.raw`[-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?`;
const one = new RegExp(`^(${number})(?:\\s*(?:kg|t|N|lb|m|cm|mm|in|×|°))?$`);
const two = new RegExp(`^\\(?\\s*(${number})\\s*(?:[;,]\\s+|;|\\s+)\\s*(${number})\\s*\\)?$`);
const twoWithComma = /^\(?\s*([-+]?[\d.eE+-]+)\s*,\s*([-+]?[\d.eE+-]+)\s*\)?$/;

const point = (text) => text.replace(",", ".");

// A number may have its unit and a decimal comma; two are parted by a comma, a semicolon or a space. What is neither the
// program refuses with a sentence.
export function settingValue(typed, setting = "") {
  const text = typed.replaceAll("−", "-").replaceAll("\u00A0", " ").trim();
  if (setting === "no_go") return text.replaceAll(" ", "").toLowerCase() || "none";  // edges: "3,5" is no number
  const single = one.exec(text);
  if (single) return point(single[1]);
  const pair = two.exec(text);
  if (pair) return `${point(pair[1])},${point(pair[2])}`;
  const plain = twoWithComma.exec(text);
  return plain ? `${plain[1]},${plain[2]}` : text.toLowerCase();
}
