// Large enough for an audience.
import { openWindow } from "../kit/dialogs.js";
import { button, download, el, rasterise } from "../kit/elements.js";
import { qrCode } from "../kit/qr_code.js";
import { say } from "../words/words.js";

// Returns undefined, or why it cannot be shown if the address is too long.
export async function showQr(address) {
  let svg;
  try {
    svg = await qrCode(address);
  } catch (error) {
    return say("The QR code cannot be made: {problem}", { problem: error.message });
  }
  if (!svg) return "The link is too long for a QR code, which holds 2,953 characters; a file has no such limit";
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
