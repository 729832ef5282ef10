// Numbers as readers write them. The decimal mark of their language is the translation of ".".
import { translated } from "./words.js";

const mark = () => translated(".");
export const usesComma = () => mark() === ",";

// "1234.5" and "(12.4, −3)" with the reader's mark: "1234,5" and "(12,4; −3)".
export function asRead(text) {
  return usesComma() ? text.replaceAll(/,\s*/g, "; ").replaceAll(".", ",") : text;
}

// With its thousands apart: "20,034.5"; where the comma is the decimal mark, "20 034,5" with narrow no-break spaces,
// since a point may be read as either.
export function number(value) {
  const text = value.toLocaleString("en");
  return usesComma() ? text.replaceAll(",", "\u202f").replace(".", ",") : text;
}

const [point, comma] = [String.raw`\.`, ","];
const apart = (by, decimal) => String.raw`\d{1,3}(?:${by}\d{3})+${decimal}\d*|\d{1,3}(?:${by}\d{3}){2,}`;
// A number as people type it, with a decimal point or comma. Points, commas and spaces between thousands are read where
// they can be nothing else: in 1,234.5 and 1.000.000.
export const typedForm = String.raw`[-+]?(?:${apart(comma, point)}|${apart(point, comma)}|${apart("[\u202f\u2009]", "[.,]")}|\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?`;

// A number of this form as JavaScript and the program write it.
export function withPoint(typed) {
  const text = typed.replaceAll(/[\u202f\u2009]/g, "");
  const marks = text.match(/[.,]/g) ?? [];
  if (marks.length < 2) return text.replace(",", ".");
  const last = marks.at(-1);
  const decimal = marks.filter((each) => each === last).length === 1 ? last : "";
  return text.replaceAll(/[.,]/g, (each) => (each === decimal ? "." : ""));
}

const first = new RegExp(typedForm);

// A text whose first number is read so, such as 15,6/m2.
export const withPointIn = (text) => text.replace(first, withPoint);

// The two readings of a number whose only mark may part thousands or decimals, as 1.000 for those who write 1,5 and
// 1,000 for those who write 1.5; undefined for others. Each is written without a doubt.
export function readings(typed) {
  const thousands = usesComma() ? "." : ",";
  const found = new RegExp(String.raw`^([-+]?[1-9]\d{0,2})[${thousands}](\d{3})$`).exec(typed);
  if (!found) return undefined;
  const [, whole, rest] = found;
  return { whole: whole + rest, decimal: asRead(String(Number(`${whole}.${rest}`))) };
}

// Those of the first number of a text, such as 1.000 kg/m2.
export const readingsIn = (text) => readings(first.exec(text)?.[0] ?? "");
