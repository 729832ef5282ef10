// The loads in each case of loading, as a table to print and to sign. A worker computes it (wasm/modules/cases.cpp).
import { casesTable } from "../kit/cases_table.js";
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, unbroken } from "../kit/elements.js";
import { askOnce } from "../page/core.js";
import { say } from "../words/words.js";

export async function show(page) {
  const { program } = page;
  const link = program.text("page_link");
  const stop = new AbortController();
  const problem = problemLine();
  const pages = el("div", { class: "pages" }, el("p", { class: "second", role: "status" }, "Loading …"));
  const print = button("Print …", { class: "button primary", disabled: true, onclick: () => globalThis.print() });
  const root = await openWindow({
    name: "cases",
    title: "All cases of loading",
    body: [
      el("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": "The cases" }, problem, pages),
      el("footer", {}, el("p", { class: "second" }, "Each condition alone, all of them, and each failure."), print),
    ],
    closed: () => stop.abort(new DOMException("closed", "AbortError")),
  });
  if (!root) return;
  try {
    if (!link)
      throw new Error(say("this polygon has no link: {problem}", { problem: program.text("page_link_problem") }));
    const found = await askOnce({ command: "cases", link }, stop.signal);
    pages.replaceChildren(
      el("h2", { class: "paper-title" }, "All cases of loading"),
      casesTable(found.table),
      ...found.said.map((text) => el("p", {}, unbroken(text))),
      el("img", {
        class: "paper-task",
        alt: "The object and its robots",
        src: `data:image/svg+xml,${encodeURIComponent(found.svg)}`,
      }),
      el("p", { class: "paper-way" }, "Date: ______________   Name: ______________________________"),
    );
    print.disabled = false;
    print.focus();
  } catch (error) {
    if (stop.signal.aborted) return;
    pages.replaceChildren();
    problem.say(say("The cases cannot be shown: {problem}", { problem: error.message }));
  }
}
