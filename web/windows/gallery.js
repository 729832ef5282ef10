import { buttonTo, openWindow, problemLine } from "../kit/dialogs.js";
import { button, el, svgEl } from "../kit/elements.js";
import { show as showExperiment } from "../experiment/experiment.js";
import { fetchJson } from "../kit/fetched.js";
import { fitted, pathOf } from "../kit/fit.js";
import { say, translated } from "../words/words.js";
import { isSame, ownOutline } from "./document_name.js";

const width = 96;
const height = 64;

// The polygon with its holes and its centre of mass, as the program reads them.
function thumbnail(program, text) {
  const { centre, vertices, holes = [] } = program.json("page_outline", text);
  const place = fitted([centre, ...vertices], width, height, 4);
  const [cx, cy] = place(centre);
  return svgEl(
    "svg",
    { viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" },
    svgEl("path", { d: pathOf([vertices, ...holes].map((ring) => ring.map(place))), "fill-rule": "evenodd" }),
    svgEl("circle", { cx, cy, r: 3 }),
  );
}

export async function show(page) {
  const filter = el("input", {
    type: "search",
    class: "field",
    placeholder: "Filter",
    "aria-label": "Filter the samples",
    autocomplete: "off",
    spellcheck: "false",
  });
  const list = el("div", { class: "scroll groups" });
  const count = el("p", { class: "for-readers", role: "status" });
  // On a phone, a keyboard that opens by itself would hide half of the gallery.
  const typing = matchMedia("(pointer: fine)").matches;
  const footer = el(
    "footer",
    {},
    buttonTo("Compare methods over many polygons …", page, () => showExperiment(page, { source: "samples" })),
  );
  const root = await openWindow({
    name: "samples",
    title: "Samples",
    tools: [filter],
    body: [list, count, footer],
    focus: typing ? filter : undefined,
  });
  if (!root) return;

  const load = async () => {
    list.replaceChildren(el("p", { class: "second", role: "status" }, "Loading …"));
    let samples;
    try {
      samples = await fetchJson("samples.json"); // [{group, title, text}]
    } catch (error) {
      const line = problemLine();
      list.replaceChildren(line, button("Try again", { onclick: load }));
      line.say(say("The samples cannot be fetched: {problem}", { problem: error.message }));
      return;
    }
    fill(page.program, list, samples, (text) => {
      const problem = page.program.text("page_open_sample", text);
      root.close();
      if (problem) page.notice(say("This sample cannot be opened: {problem}.", { problem }), true);
    });
    connect(root, filter, list, count);
    if (!typing && root.contains(document.activeElement)) list.querySelector("button")?.focus();
  };
  await load();
}

function fill(program, list, samples, choose) {
  const groups = new Map();
  for (const sample of samples) {
    const group = sample.group || "To begin with";
    if (!groups.has(group)) groups.set(group, []);
    groups.get(group).push(sample);
  }
  const own = ownOutline(program);
  const isOpen = (text) => (isSame(program, text, own) ? "true" : undefined);
  list.replaceChildren(
    ...[...groups].map(([group, members]) =>
      el(
        "section",
        {},
        el("h3", {}, group),
        el(
          "ul",
          {},
          ...members.map(({ title, text }) =>
            el(
              "li",
              { "data-words": `${translated(title)} ${translated(group)}`.toLowerCase() },
              el(
                "button",
                {
                  type: "button",
                  class: "sample",
                  tabindex: "-1",
                  "aria-current": isOpen(text),
                  onclick: () => choose(text),
                },
                thumbnail(program, text),
                el("span", {}, title),
              ),
            ),
          ),
        ),
      ),
    ),
    el("p", { class: "second nothing", hidden: true }, "No sample matches."),
  );
}

function connect(root, filter, list, count) {
  const shown = () => [...list.querySelectorAll("li:not([hidden]) > button")];
  // Tab reaches only one sample; arrow keys move to the others.
  const reach = (sample) => {
    for (const other of list.querySelectorAll(".sample[tabindex='0']")) other.tabIndex = -1;
    if (sample) sample.tabIndex = 0;
  };
  const narrow = () => {
    const words = filter.value.toLowerCase().split(/\s+/);
    for (const item of list.querySelectorAll("li"))
      item.hidden = !words.every((word) => item.dataset.words.includes(word));
    for (const section of list.querySelectorAll("section")) section.hidden = !section.querySelector("li:not([hidden])");
    const found = shown();
    list.querySelector(".nothing").hidden = found.length > 0;
    list.scrollTop = 0;
    if (filter.value) count.textContent = say("{number} samples", { number: found.length });
    reach(found[0]);
  };
  filter.addEventListener("input", narrow);
  filter.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") focus(shown()[0]);
    else if (event.key === "Enter") shown()[0]?.click();
    else return;
    event.preventDefault();
  });
  const focus = (sample) => {
    if (!sample) return;
    reach(sample);
    sample.focus();
  };
  list.addEventListener("focusin", (event) => event.target.matches(".sample") && reach(event.target));
  list.addEventListener("keydown", (event) => {
    const all = shown();
    const at = all.indexOf(document.activeElement);
    if (at < 0) return;
    if (event.key === "ArrowUp" && !nextRow(all, at, -1)) filter.focus();
    else if (event.key.startsWith("Arrow"))
      focus(
        {
          ArrowLeft: all[at - 1],
          ArrowRight: all[at + 1],
          ArrowUp: nextRow(all, at, -1),
          ArrowDown: nextRow(all, at, 1),
        }[event.key],
      );
    else if (event.key === "Home") focus(all[0]);
    else if (event.key === "End") focus(all.at(-1));
    else return;
    event.preventDefault();
  });
  narrow();
}

// In the row above or below.
function nextRow(all, at, direction) {
  const here = all[at].getBoundingClientRect();
  const others = all
    .map((sample) => ({ sample, box: sample.getBoundingClientRect() }))
    .filter(({ box }) => direction * (box.top - here.top) > 1);
  const row = Math.min(...others.map(({ box }) => direction * box.top));
  const distance = ({ box }) => Math.abs(box.left - here.left);
  return others.filter(({ box }) => direction * box.top < row + 1).sort((a, b) => distance(a) - distance(b))[0]?.sample;
}
