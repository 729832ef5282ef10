// An address as QR code: black on white whatever the theme, with the quiet zone that readers need.
import { askOnce } from "../page/core.js";

const quiet = 4; // modules

// Neighbouring dark modules of a row become one rectangle.
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

// SVG; undefined if the address is too long for a code. Throws if the core cannot be loaded.
export async function qrCode(address) {
  const { rows } = await askOnce({ command: "qr", text: address });
  return rows.length ? picture(rows) : undefined;
}
