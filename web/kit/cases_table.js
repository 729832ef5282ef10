// The table of all cases of loading (wasm/modules/cases.h), for paper.
import { el, unbroken } from "./elements.js";

export function casesTable({ headings, rows, worst }) {
  const cells = (texts, kind) => texts.map((text) => el(kind, {}, unbroken(text)));
  return el(
    "table",
    { class: "numbers cases" },
    el("thead", {}, el("tr", {}, ...cells([...headings, ""], "th"))),
    el(
      "tbody",
      {},
      ...rows.map(([name, ...values], i) =>
        el(
          "tr",
          { class: i === worst ? "worst" : "" },
          el("th", { scope: "row" }, unbroken(name)),
          ...cells(values, "td"),
          el("td", {}, i === worst ? "worst" : ""),
        ),
      ),
    ),
  );
}
