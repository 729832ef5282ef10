// Share and save: the link, its QR code, and files.
import { openWindow, problemLine } from "../kit/dialogs.js";
import { button, download, el, icon, rasterise } from "../kit/elements.js";
import { number } from "../words/numbers.js";
import { say, translated } from "../words/words.js";
import { documentName } from "./document_name.js";
import { showQr } from "./qr.js";
import { forgetAside, textsAside } from "../page/recovery.js";

// A row for each robot; numbers read back to the same double. 0 replaces values that differ from it only by rounding.
function csv({ teams }) {
  const least = 1e-13 * Math.max(0, ...teams.flatMap(({ ends }) => ends.flat().map(Math.abs)));
  const exact = (value) => String(Math.abs(value) < least ? 0 : value);
  const sum = (numbers) => numbers.reduce((all, each) => all + each, 0);
  const rows = teams.flatMap(({ ends, ratio, loads }, team) =>
    ends.map(([x, y], end) =>
      [ends.length * team + end + 1, team + 1, `r${end + 1}`, x, y, loads[end], loads[end] / sum(loads), ratio].map(
        exact,
      ),
    ),
  );
  return [["robot", "team", "end", "x", "y", "load", "share_of_team", "load_ratio"], ...rows]
    .map((row) => `${row.join(",")}\n`)
    .join("");
}

const files = [
  [
    "Polygon",
    [
      ["Text", "Lines (x,y)", ".txt", "text/plain", (p) => p.text("page_text")],
      ["WKT", "The outline only", ".wkt", "text/plain", (p) => p.text("page_wkt")],
      ["GeoJSON", "With centre of mass", ".geojson", "application/geo+json", (p) => p.text("page_geojson")],
    ],
  ],
  [
    "Picture",
    [
      ["SVG", "Sharp; reopens here", ".svg", "image/svg+xml", (p) => p.text("page_svg")],
      ["PNG", "Twice the pixels", ".png", "image/png", (p) => rasterise(p.text("page_svg"), 2)],
    ],
  ],
  [
    "Result",
    [
      ["JSON", "Everything; reopens here", "-result.json", "application/json", (p) => p.text("page_state")],
      ["CSV", "A row per robot", ".csv", "text/csv", (p) => csv(JSON.parse(p.text("page_state")))],
    ],
  ],
  [
    "Robot poses",
    [
      ["Poses as CSV", "Where each stands and faces", "-poses.csv", "text/csv", (p) => p.text("page_poses", ".csv")],
      [
        "Poses as JSON",
        "The same for programs",
        "-poses.json",
        "application/json",
        (p) => p.text("page_poses", ".json"),
      ],
      [
        "Poses for ROS 2",
        "A PoseArray in YAML",
        "-poses.yaml",
        "application/yaml",
        (p) => p.text("page_poses", ".yaml"),
      ],
    ],
  ],
];

export async function show(page) {
  const link = page.program.text("page_link");
  const address = link && page.sharedAddress(link);
  const problem = problemLine();
  const root = await openWindow({
    name: "save",
    title: "Share and save",
    body: [
      el(
        "div",
        { class: "scroll" },
        ...share(page, address, problem),
        ...challengeLink(page, problem),
        problem,
        ...files.map((group) => choices(page, group, problem)),
        ...aside(),
      ),
    ],
  });
  if (!root) return;
  root.querySelector(".primary, .choice").focus();
  if (link) return;
  problem.say(
    say("There is no link: {problem}. Save a file instead", { problem: page.program.text("page_link_problem") }),
  );
}

// The texts that stopped the page when they were opened.
function aside() {
  const texts = textsAside();
  if (!texts.length) return [];
  const section = el(
    "section",
    {},
    el("h3", {}, "Set aside"),
    el("p", { class: "second" }, "The page stopped while opening these texts. The newest is first."),
    el(
      "div",
      { class: "choices" },
      ...texts.map((text, i) =>
        el(
          "button",
          {
            type: "button",
            class: "choice",
            onclick: () => download(new Blob([text], { type: "text/plain" }), `evenlift-aside-${i + 1}.txt`),
          },
          el(
            "span",
            {},
            el("b", {}, say("Text {number}", { number: i + 1 })),
            " ",
            el("small", {}, say("{number} characters", { number: number(text.length) })),
          ),
        ),
      ),
      button("Forget", {
        onclick: () => {
          forgetAside();
          section.remove();
        },
      }),
    ),
  );
  return [section];
}

function share(page, address, problem) {
  if (!address) return [];
  const said = el("p", { class: "second", role: "status" }, page.aboutLink(address));
  const field = el("input", {
    id: "link",
    class: "field",
    readonly: true,
    value: address,
    "aria-label": "Link",
    onfocus: () => field.select(),
  });
  const copy = button("Copy", { class: "button primary" }, "copy");
  copy.addEventListener("click", async () => {
    const done = await page.copy(address);
    if (!done) {
      problem.say("The browser did not allow copying. Copy the link from the field");
      return field.focus();
    }
    copy.replaceChildren(icon("check"), translated("Copied"));
    said.textContent = `${translated("The link is copied.")} ${page.aboutLink(address)}`;
    setTimeout(() => copy.replaceChildren(icon("copy"), translated("Copy")), 2500);
  });
  const embed = button("Copy code to embed", {
    onclick: async () => {
      const done = await page.copy(embedCode(address));
      if (done)
        said.textContent = translated("The code is copied: a figure of this polygon for an article or a course page.");
      else problem.say("The browser did not allow copying");
    },
  });
  const qr = button("QR code", { onclick: async () => problem.say(await showQr(address)) }, "qr");
  return [el("h3", {}, "Link"), el("div", { class: "row" }, field, copy, qr), el("div", { class: "row" }, said, embed)];
}

// For showing the address as a figure.
function embedCode(address) {
  const url = new URL(address);
  url.searchParams.set("embed", "1");
  const escaped = url.href.replaceAll("&", "&amp;").replaceAll('"', "&quot;");
  return `<iframe src="${escaped}" title="evenlift" width="720" height="480" style="border: 0; max-width: 100%"></iframe>`;
}

// In a walkthrough: the same steps with guesses. Otherwise: the object alone, on which somebody places robots.
function challengeLink(page, problem) {
  const { program } = page;
  const guesses = program.number("page_walkthrough_is_open") === 1;
  const link = guesses
    ? program.text("page_without_step", program.text("page_link"))
    : program.text("page_challenge_link");
  if (!link) return [];
  const address = guesses ? page.address(link, true) : page.placesAddress(link, { place: 4 });
  const said = el(
    "p",
    { class: "second", role: "status" },
    guesses
      ? "Opens the walkthrough of this polygon, which asks for a guess before each choice."
      : "Opens the object alone and asks: where would you put four robots? Only then does it show evenlift's.",
  );
  const copy = button(
    "Challenge link",
    {
      onclick: async () => {
        if (await page.copy(address)) said.textContent = translated("The challenge link is copied.");
        else problem.say(say("The browser did not allow copying. This is the challenge link: {address}", { address }));
      },
    },
    "copy",
  );
  return [el("div", { class: "row challenge" }, said, copy)];
}

function choices(page, [group, members], problem) {
  return el(
    "section",
    {},
    el("h3", {}, group),
    el(
      "div",
      { class: "choices" },
      ...members.map(([name, about, file, type, make]) => {
        const save = async () => {
          try {
            const [content, called] = await Promise.all([make(page.program), documentName(page.program)]);
            download(new Blob([content], { type }), called + file);
            problem.say("");
          } catch (error) {
            problem.say(say("The file cannot be made: {problem}", { problem: error.message }));
          }
        };
        return el(
          "button",
          { type: "button", class: "choice", onclick: save },
          icon("save"),
          el("span", {}, el("b", {}, name), " ", el("small", {}, about)),
        );
      }),
    ),
  );
}
