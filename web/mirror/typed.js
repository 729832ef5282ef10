// Numbers as users type them, and as the program reads them (core/include/evenlift/settings.h).
import { readings, typedForm, usesComma, withPoint } from "../words/numbers.js";
import { say, translated } from "../words/words.js";

// The value to type over: "437 kg" becomes "437", and "(12.4, −3)" "12.4, -3".
export function plainValue(shown) {
  const text = shown.replaceAll("−", "-").replaceAll("\u00A0", " ").trim();
  if (text === "–") return ""; // nothing yet
  if (text.startsWith("(")) return text.slice(1, -1);
  return /^[-\d.]/.test(text) ? text.split(" ")[0].replace(/°$/, "") : text;
}

const unit = "kg|t|N|lb|m|cm|mm|in";
const one = new RegExp(`^(${typedForm})(?:\\s*(?:(${unit})|×|°))?$`);
const two = new RegExp(`^\\(?\\s*(${typedForm})\\s*(?:[;,]\\s+|;|\\s+)\\s*(${typedForm})\\s*\\)?$`);
const twoWithComma = /^\(?\s*([-+]?[\d.eE+-]+)\s*,\s*([-+]?[\d.eE+-]+)\s*\)?$/;
const twoWithUnits = new RegExp(
  `^\\(?\\s*(${typedForm})\\s*(${unit})(?:\\s*[;,]\\s*|\\s+)(${typedForm})\\s*(${unit})\\s*\\)?$`,
);

// "1 000 kg" as one number.
const joined = (text) => text.replace(/^[-+]?\d{1,3}(?: \d{3})+(?!\d)/, (digits) => digits.replaceAll(" ", ""));

// In mm and in kg, each as a fraction so that nothing is rounded here. 1 kg weighs 9.80665 N.
const kinds = [
  { name: "length", units: { m: [1000, 1], cm: [10, 1], mm: [1, 1], in: [25.4, 1] } },
  { name: "weight", units: { kg: [1, 1], t: [1000, 1], N: [1, 9.80665], lb: [0.45359237, 1] } },
];
const kindOf = (unit) => kinds.find(({ units }) => Object.hasOwn(units, unit));

// The "mm" of "20 mm"; "" without a unit.
export function unitOf(shown) {
  return new RegExp(`\\d\\s(${unit})$`).exec(shown)?.[1] ?? "";
}

// Undefined if the field has no unit or one of another kind.
function converted(typed, from, to) {
  if (from === to) return withPoint(typed);
  const { units } = kindOf(from);
  if (!Object.hasOwn(units, to)) return undefined;
  const [times, by] = units[from],
    [per, of] = units[to];
  // As exact as the typed number, with at least nine digits: 200 N are 20.3943243 kg, and 20 does not become
  // 20.000000000000004.
  const digits = withPoint(typed).replace(/e.*$/i, "").replace(/\D/g, "").replace(/^0+/, "").length;
  return String(
    Number(((Number(withPoint(typed)) * times * of) / (by * per)).toPrecision(Math.min(12, Math.max(9, digits)))),
  );
}

const tidied = (typed) => typed.replaceAll("−", "-").replaceAll("\u00A0", " ").trim();

const strange = new RegExp(`^${typedForm}\\s*([A-Za-zµ"'′″]+)$`);

// Settings that are not one number or pair of numbers in units of length or weight.
const ofOtherKinds = () => ["no_go", "readings", "readings_tilted", ...ratios];

// The two readings of a typed number, each with its unit; undefined if there is only one.
export function typedDoubt(typed, setting) {
  if (setting === "com" || ofOtherKinds().includes(setting)) return undefined;
  const [, bare, of = ""] = one.exec(tidied(typed)) ?? [],
    doubt = bare && readings(bare);
  if (!doubt) return undefined;
  const withUnit = (number) => (of ? `${number} ${of}` : number);
  return { whole: withUnit(doubt.whole), decimal: withUnit(doubt.decimal) };
}

// Why a number cannot be set: the unit after it, or a mark that may part thousands or decimals. A sentence without its full
// stop; "" for neither. `setting` and `own` are as below; `isLength` marks a length, even without a unit.
export function typedProblem(typed, setting, own, isLength) {
  const text = tidied(typed);
  if (ofOtherKinds().includes(setting)) return "";
  const doubt = typedDoubt(typed, setting);
  if (doubt) return say("“{text}” may mean {whole} or {decimal}: type one of these", { text, ...doubt });
  const unknown = one.test(text) ? undefined : strange.exec(text)?.[1];
  if (unknown)
    return say(
      "“{unit}” is not a unit that evenlift knows: lengths are in m, cm, mm or in, and weights in kg, t, N or lb",
      { unit: unknown },
    );
  const found = one.exec(text)?.slice(2) ?? twoWithUnits.exec(text)?.filter((_, i) => i === 2 || i === 4) ?? [];
  const from = found.find((each) => each && !(own && kindOf(each) === kindOf(own)) && each !== own);
  if (!from) return "";
  const isOfLength = kindOf(from).name === "length";
  const pattern = own
    ? isOfLength
      ? "“{text}” is a length, but this number is a weight in {own}"
      : "“{text}” is a weight, but this number is a length in {own}"
    : isLength && isOfLength
      ? "“{text}” has the unit {from}, but lengths have none here: type the number alone, or choose a unit of length under Object"
      : "“{text}” has the unit {from}, but this number has none: type the number alone";
  return say(pattern, { text, from, own });
}

// The program reads their units. Without one, these are in percent.
const percents = ["slope", "weight_doubt", "level_error", "tilted"];
const ratios = [...percents, "acceleration", "reading_error", "heading"];

const known = ["all", "centroid", "no limit", "none", "not known"];
const inEnglish = (text) =>
  known.find((word) => translated(word) !== word && translated(word).toLowerCase() === text.toLowerCase()) ?? text;

function slopeValue(text) {
  const bare = new RegExp(`^${typedForm}$`).test(text);
  return `${withPoint(text)}${bare ? "%" : ""}`;
}

// A number may have a unit and a decimal comma; a comma, a semicolon or a space separates two numbers. `own` is the
// field's unit or "". The program refuses everything else with a message, also a unit that the field cannot have:
// without it the number would mean another quantity.
export function settingValue(typed, setting = "", own = "") {
  const text = inEnglish(tidied(typed));
  if (setting === "no_go") {
    // edges: "3,5" is not a number
    const apart = text.includes(";") ? text.replaceAll(",", ".").replaceAll(";", ",") : text; // "3:0,25-0,5; 27"
    const edges = apart.replaceAll(" ", "");
    if (/^(none)?$/i.test(edges)) return "none";
    return /[a-z]/i.test(edges) ? text.trim() : edges; // a refused value is quoted as typed
  }
  if (setting === "teams" && text.toLowerCase() === "all") return "max"; // as on the button
  if (setting === "capacity" && text.toLowerCase() === "no limit") return "none";
  if (text.toLowerCase() === "not known") return "none";
  // A number without a unit has the one that is shown.
  if (setting.startsWith("readings")) return text.replaceAll(";", " ");
  if (setting === "heading") return twoWithComma.test(text) ? text.replaceAll(" ", "") : withPoint(text);
  if (ratios.includes(setting)) return percents.includes(setting) ? slopeValue(text) : withPoint(text);
  const single = setting === "com" ? null : one.exec(joined(text)); // here "10,20" means two numbers
  if (single) return single[2] ? (converted(single[1], single[2], own) ?? text) : withPoint(single[1]);
  const pair = two.exec(text);
  if (pair) return `${withPoint(pair[1])},${withPoint(pair[2])}`;
  // Where the comma is the decimal mark, "403,8" is one number.
  const plain = (!usesComma() || text.includes(".")) && twoWithComma.exec(text);
  if (plain) return `${plain[1]},${plain[2]}`;
  const pairWithUnits = twoWithUnits.exec(text);
  if (!pairWithUnits) return text.toLowerCase();
  const [, x, unitOfX, y, unitOfY] = pairWithUnits;
  const both = [converted(x, unitOfX, own), converted(y, unitOfY, own)];
  return both.includes(undefined) ? text : both.join(",");
}
