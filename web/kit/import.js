// Reads drawings, tables and results as polygons.
import { askOnce } from "../page/core.js";

// `tolerance` is the distance between curves and edges, or 0 for the default. Returns { problem }, a message, or what
// wasm/modules/kinds.h says of "shapes".
export async function readShapes(text, tolerance = 0) {
  try {
    return await askOnce({ command: "shapes", text, tolerance });
  } catch ({ message }) {
    return {
      problem:
        message === "the server cannot be reached"
          ? "The module that reads drawings and tables cannot be loaded: the server cannot be reached"
          : message,
    };
  }
}

// The text to open: a link, if settings are wanted and the file has some.
export const textOf = ({ text, link }, withSettings) => (withSettings && link) || text;
