// Without WebGL 2, the SVG that Save writes replaces the canvas. Loaded only then.
import { ensureStyles } from "../kit/dialogs.js";
import { button, el } from "../kit/elements.js";
import { underWay } from "../page/under_way.js";

// The verdict, which is the picture's description.
function described(svg) {
  return new DOMParser().parseFromString(svg, "image/svg+xml").querySelector("desc").textContent;
}

// `draw` shows the program's present picture, and `tell` a message above it. With `save`, a button calls it.
export async function showStill(program, { missing, save }) {
  await Promise.all([ensureStyles(), ensureStyles("still.css")]);
  const picture = el("img", {});
  const verdict = el("p", { class: "verdict", "aria-hidden": "true" }); // the picture's own text is the same
  const told = document.getElementById("alert");
  told.className = "problem";
  const canvas = document.getElementById("canvas");
  canvas.hidden = true;
  // The focus lets keys scroll it.
  canvas.after(
    el(
      "article",
      { id: "still", tabindex: "0", "aria-label": "The picture and its verdict" },
      picture,
      el(
        "section",
        {},
        el("h1", {}, "evenlift"),
        told,
        verdict,
        el(
          "div",
          { class: "missing" },
          el("strong", {}, "This is a still picture."),
          ...missing.map((text) => el("p", {}, text)),
        ),
        ...(save ? [button("Save", { onclick: save }, "save")] : []),
      ),
    ),
  );
  let shown;
  return {
    draw() {
      const svg = program.text("page_svg");
      if (svg === shown) return;
      shown = svg;
      URL.revokeObjectURL(picture.src);
      picture.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
      picture.alt = verdict.textContent = described(svg);
      underWay(picture.decode()).catch(() => {}); // another picture may come before this one is decoded
    },
    tell(text) {
      told.textContent = text;
    },
  };
}
