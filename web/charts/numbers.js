// Numbers as the program writes them (core/include/evenlift/output/words.h).
import { asRead } from "../words/numbers.js";

// Rounds the shortest decimal that reads back to the number to the nearest, a half away from zero. So 2.345 is "2.35",
// although its double is a little less; toFixed() would give "2.34". For sizes below 10^15.
export function fixed(value, decimals) {
  const [digits, exponent = "0"] = String(Math.abs(value)).split("e");
  const units = Math.round(Number(`${digits}e${Number(exponent) + decimals}`));
  const text = (units / 10 ** decimals).toFixed(decimals);
  return value < 0 && units > 0 ? `−${text}` : text;
}

// Shares are percentages.
export const inUnit = ({ unit }, value) => (unit === "%" ? 100 * value : value);
export const inDigits = (figure, value) => asRead(fixed(inUnit(figure, value), figure.unit === "%" ? 1 : 2));
