// Compares the greedy choice of teams with the optimum. A worker computes it (wasm/modules/optimum.cpp), nearly
// always in less than a second.
import { openWindow, problemLine } from "../kit/dialogs.js";
import { el } from "../kit/elements.js";
import { askOnce } from "../page/core.js";
import { say } from "../words/words.js";

// Far more than needed if the optimum can be found at all, so that a busy machine gives the same answer. Closing the
// window ends the wait.
const seconds = 20;

function table(rows) {
  const cells = (kind, texts) => el("tr", {}, ...texts.map((text) => el(kind, {}, text)));
  return el(
    "table",
    { class: "numbers" },
    el("thead", {}, cells("th", ["Choice", "Covers", "Each carries", "Holds", "Candidates"])),
    el("tbody", {}, ...rows.map((row) => cells("td", row))),
  );
}

function picture(svg, name, urls) {
  const url = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  urls.push(url);
  return el(
    "figure",
    {},
    el("img", { src: url, alt: say("{name}: the teams and their lifting base", { name }) }),
    el("figcaption", {}, name),
  );
}

export async function show(page) {
  const { program } = page;
  const link = program.text("page_link");
  const stop = new AbortController();
  const urls = [];
  const problem = problemLine();
  const found = el(
    "div",
    { class: "optimum" },
    el(
      "p",
      { class: "second", role: "status" },
      say("Looking for the best choice, for at most {seconds} seconds …", { seconds }),
    ),
  );
  const root = await openWindow({
    name: "optimum",
    title: "Compared with the optimum",
    body: [
      el("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": "The comparison" }, problem, found),
    ],
    closed: () => {
      stop.abort(new DOMException("closed", "AbortError"));
      urls.forEach((url) => URL.revokeObjectURL(url));
    },
  });
  if (!root) return;
  try {
    if (!link)
      throw new Error(say("this polygon has no link: {problem}", { problem: program.text("page_link_problem") }));
    const { rows, said, pictures } = await askOnce({ command: "optimum", link, seconds }, stop.signal);
    found.replaceChildren(
      el("div", { class: "pair" }, ...pictures.map((svg, i) => picture(svg, rows[i][0], urls))),
      table(rows),
      el("div", { role: "status" }, ...said.map((sentence) => el("p", {}, sentence))),
    );
  } catch (error) {
    if (stop.signal.aborted) return;
    found.replaceChildren();
    problem.say(say("The optimum cannot be shown: {problem}", { problem: error.message }));
  }
}
