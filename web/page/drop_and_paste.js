// Opens files and texts that are dropped or pasted anywhere on the page.
import { translated } from "../words/words.js";
import { underWay } from "./under_way.js";

const typesIn = "input, textarea";

export function connectDropAndPaste(page) {
  const take = async (data, textName) => {
    const given = { files: [...data.files], text: data.getData("text/plain") }; // gone after this event
    const { take: open } = await page.windows();
    await open(page, given, textName);
  };
  addEventListener("paste", (event) => {
    if (event.target.closest?.(typesIn)) return;
    event.preventDefault();
    underWay(take(event.clipboardData, "The pasted text"));
  });

  let own = false; // a text of this page is being dragged, not a polygon
  addEventListener("dragstart", () => {
    own = true;
  });
  addEventListener("dragend", () => {
    own = false;
  });
  const opens = (event) =>
    !own &&
    event.dataTransfer?.types.some((type) => type === "Files" || type === "text/plain") &&
    (event.dataTransfer.types.includes("Files") || !event.target.closest?.(typesIn));
  addEventListener("dragover", (event) => {
    if (!opens(event)) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = "copy";
    underWay(hint(page, true));
  });
  addEventListener("dragleave", (event) => event.relatedTarget === null && underWay(hint(page, false)));
  addEventListener("drop", (event) => {
    underWay(hint(page, false));
    if (!opens(event)) return;
    event.preventDefault();
    underWay(take(event.dataTransfer, "The dropped text"));
  });
}

let wanted = false;
async function hint(page, on) {
  if (wanted === on) return;
  wanted = on;
  const { ensureStyles } = await page.windows();
  await ensureStyles();
  let element = document.getElementById("drop-hint");
  if (!element && wanted) {
    element = Object.assign(document.createElement("div"), {
      id: "drop-hint",
      popover: "manual",
      textContent: translated("Drop to open"),
    });
    document.body.append(element);
    element.showPopover?.(); // above an open window
  } else if (element && !wanted) {
    element.remove();
  }
}
