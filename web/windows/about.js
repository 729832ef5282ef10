import { buttonTo, openWindow } from "../kit/dialogs.js";
import { el } from "../kit/elements.js";
import { ask, fetchJson } from "../kit/fetched.js";
import { say } from "../words/words.js";
import { show as showGlossary } from "../lessons/glossary.js";
import { show as showKeys } from "./keys.js";
import { show as showTour } from "./tour.js";
import { show as showWelcome } from "./welcome.js";

const link = (file, text) =>
  el("a", { href: new URL(file, import.meta.url).href, target: "_blank", rel: "noopener" }, text);

// In the page's folder (assets/docs_html.py).
const docs = [
  ["docs-lessons.html", "How to write a lesson"],
  ["docs-teaching.html", "Teaching with evenlift: three sessions"],
  ["docs-page.html", "The page: links, embedding, scripting"],
  ["docs-algorithm.html", "The algorithm, stage by stage"],
  ["docs-stands.html", "Robots with a size, and where they can stand"],
  ["docs-who-bears-what.html", "Who carries what, and what may go wrong"],
  ["docs-link-format.html", "The format of links"],
];

export async function show(page) {
  const version = el("span", {});
  const licences = el("pre", { tabindex: "0" }, "Loading …");
  const more = el(
    "details",
    { ontoggle: () => more.open && fill(licences) },
    el("summary", {}, "Licences of its components"),
    licences,
  );
  const root = await openWindow({
    name: "about",
    title: "About evenlift",
    body: [
      el(
        "div",
        { class: "scroll" },
        el(
          "p",
          {},
          "evenlift decides where teams of robots stand around a flat object so that they lift it together, each with nearly the same load. The two robots of a team stand on opposite sides of the centre of mass. Teams are chosen so that the loads are even and the lifting base is wide. evenlift also finds out whether the robots' contacts alone keep the object from sliding and turning.",
        ),
        el(
          "p",
          {},
          "It implements the thesis ",
          el("cite", {}, "A Weight-Distributing Placement Algorithm for Large Teams of Lifting Robots"),
          ". Everything is computed here in the browser: nothing that you draw is sent anywhere.",
        ),
        el("h3", {}, "Further reading"),
        el("ul", { class: "plain" }, ...docs.map(([file, title]) => el("li", {}, link(file, title)))),
        el("h3", {}, "Version and licence"),
        el(
          "p",
          {},
          version,
          "MIT licence: use it, change it and pass it on, with its notice. The source is in the project from which this page was built. Its README explains how to build the page and the command-line program.",
        ),
        more,
      ),
      el(
        "footer",
        {},
        buttonTo("How to begin", page, showWelcome),
        buttonTo("Take the tour", page, showTour),
        buttonTo("Glossary", page, showGlossary),
        buttonTo("Keys", page, showKeys),
      ),
    ],
  });
  if (!root) return;
  const { version: number } = await fetchJson("version.json").catch(() => ({}));
  if (number) version.textContent = `${say("Version {number}.", { number })} `;
}

async function fill(licences) {
  if (licences.dataset.filled) return;
  try {
    licences.textContent = await (await ask(new URL("licences.txt", import.meta.url))).text();
    licences.dataset.filled = "1";
  } catch (error) {
    licences.textContent = say("The licences cannot be fetched: {problem}.", { problem: error.message });
  }
}
