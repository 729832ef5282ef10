// The keys, by groups, from the program's own table (wasm/actions/actions.h).
import { buttonTo, fadeFoot, openWindow } from "../kit/dialogs.js";
import { el } from "../kit/elements.js";
import { say, translated } from "../words/words.js";
import { show as showGlossary } from "../lessons/glossary.js";
import { show as showTour } from "./tour.js";

const groups = ["Files and sharing", "Drawing and editing", "Teams and method", "What is shown", "Lesson", "Help"];
const onMac = /Mac|iPhone|iPad/.test(navigator.platform);

function rows(program) {
  return program.json("page_keys").map(({ group, key, label }) => ({
    group: groups[group],
    key: parts(onMac ? key.replace("Ctrl", "Cmd") : key)
      .map((part) => (part.length > 1 ? translated(part) : part))
      .join(""),
    label: translated(label),
  }));
}

const parts = (key) => key.split(/(\+(?=.)|, | (?=.$))/).filter(Boolean);

// "Ctrl+Z" as <kbd>Ctrl</kbd>+<kbd>Z</kbd>.
function keyed(key) {
  return parts(key).map((part) => (/^(\+|, | )$/.test(part) && key !== "+" ? part : el("kbd", {}, new Text(part))));
}

// About links to this list, so it is not imported.
const showAbout = async (page) => (await page.windows()).about(page);

export async function show(page) {
  const all = rows(page.program);
  const filter = el("input", {
    type: "search",
    class: "field",
    placeholder: "Filter",
    "aria-label": "Filter the keys",
    autocomplete: "off",
    spellcheck: "false",
  });
  const count = el("p", { class: "for-readers", role: "status" });
  const none = el("p", { class: "second", hidden: true }, "No key matches.");
  const sections = groups
    .filter((group) => all.some((row) => row.group === group))
    .map((group) =>
      el(
        "section",
        {},
        el("h3", {}, group),
        el(
          "dl",
          {},
          ...all
            .filter((row) => row.group === group)
            .map(({ key, label }) =>
              el(
                "div",
                { "data-words": `${label} ${key} ${translated(group)}`.toLowerCase() },
                el("dt", {}, label),
                el("dd", {}, ...keyed(key)),
              ),
            ),
        ),
      ),
    );
  // A browser would only clear the field, and the next key would be typed into it.
  filter.addEventListener("keydown", (event) => event.key === "Escape" && filter.closest("dialog").close());
  filter.addEventListener("input", () => {
    const words = filter.value.toLowerCase().split(/\s+/);
    let found = 0;
    for (const section of sections) {
      for (const row of section.querySelectorAll("dl > div")) {
        row.hidden = !words.every((word) => row.dataset.words.includes(word));
        if (!row.hidden) ++found;
      }
      section.hidden = !section.querySelector("dl > div:not([hidden])");
    }
    none.hidden = found > 0;
    count.textContent = say("{number} keys", { number: found });
  });
  const scroll = el(
    "div",
    { class: "scroll", tabindex: "0", role: "group", "aria-label": "The list of keys" },
    el("div", { class: "key-groups" }, ...sections),
    none,
    el(
      "p",
      { class: "second" },
      "By hand: drag a vertex or the centre of mass; drag the ground to move the view; scroll or pinch to zoom; double-click an edge to add a vertex.",
    ),
    count,
  );
  await openWindow({
    name: "keys",
    title: "Keys",
    tools: [filter],
    body: [
      scroll,
      el(
        "footer",
        {},
        buttonTo("Take the tour", page, showTour),
        buttonTo("Glossary", page, showGlossary),
        buttonTo("About", page, showAbout),
      ),
    ],
    focus: matchMedia("(pointer: fine)").matches ? filter : undefined,
  });
  fadeFoot(scroll);
}
