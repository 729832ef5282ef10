// The link as a QR code, large enough for an audience: black on white whatever the theme, with the quiet zone that
// readers need.
import { coreModule } from "../kit/core_module.js";
import { openWindow } from "../kit/dialogs.js";
import { button, download, el, rasterise } from "../kit/elements.js";

const qrModule = coreModule(() => import("./qr_core.js"));

const quiet = 4; // modules

// An SVG of rows of 0 and 1. Neighbouring dark modules of a row become one rectangle.
function picture(rows) {
  const side = rows.length + 2 * quiet;
  const runs = rows.flatMap((row, y) =>
    [...row.matchAll(/1+/g)].map((run) => `M${run.index + quiet} ${y + quiet}h${run[0].length}v1h-${run[0].length}z`),
  );
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${8 * side}" height="${8 * side}" viewBox="0 0 ${side} ${side}" shape-rendering="crispEdges">` +
    `<path fill="#fff" d="M0 0h${side}v${side}H0z"/><path d="${runs.join("")}"/></svg>\n`
  );
}

// Returns why it cannot be shown, if the address is too long; otherwise undefined.
export async function showQr(address) {
  let rows;
  try {
    rows = (await qrModule()).text("qr_code", address).split("\n").filter(Boolean);
  } catch (error) {
    return `The QR code cannot be made: ${error.message}`;
  }
  if (!rows.length)
    return "The link is too long for a QR code, which holds 2,953 characters; a saved file holds any polygon";
  const svg = picture(rows);
  const image = el("img", {
    class: "qr",
    alt: "QR code of the link",
    src: URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })),
  });
  const save = (name, make) =>
    button(name, { onclick: async () => download(await make(), `evenlift-link.${name.toLowerCase()}`) }, "save");
  await openWindow({
    name: "qr",
    title: "QR code of the link",
    over: true,
    body: [
      el("div", { class: "scroll" }, image),
      el(
        "footer",
        {},
        save("SVG", () => new Blob([svg], { type: "image/svg+xml" })),
        save("PNG", () => rasterise(svg, 2)),
      ),
    ],
    closed: () => URL.revokeObjectURL(image.src),
  });
  return "";
}
