// Reads drawings, tables and results as polygons, in a module of the core that is fetched at the first use.
import { coreModule } from "./core_module.js";

const reader = coreModule(() => import("./import_core.js"));

let last; // the text in the module

// `tolerance` is the distance between curves and edges, or 0 for the default. Returns { problem }, a message, or
// { format, unit, notes, doubtful, leftOpen(), shapes }. In a doubtful drawing, what was left out is larger than any
// shape. leftOpen() has the lines that close no shape. A shape has a description, the tolerance of its curves (or 0),
// outline() and holes() for a picture, and text() for the program; with settings, text() may return a link.
export async function readShapes(text, tolerance = 0) {
  let program;
  try {
    program = await reader();
  } catch {
    return { problem: "The module that reads drawings and tables cannot be loaded: the server cannot be reached" };
  }
  const me = {};
  const read = () => {
    last = me;
    return program.text("import_read", text.replaceAll("\0", "\x01"), tolerance);
  };
  // The module may have read another text since.
  const asked = (name, ...args) => {
    if (last !== me) read();
    return program.text(name, ...args);
  };
  const problem = read();
  if (problem) return { problem };
  const shape = (_, i) => ({
    name: program.text("import_name", i),
    description: program.text("import_describe", i),
    tolerance: program.number("import_tolerance", i),
    outline: () => JSON.parse(asked("import_outline", i)),
    holes: () => JSON.parse(asked("import_holes", i)),
    text: (withSettings) => asked("import_text", i, withSettings ? 1 : 0),
  });
  return {
    format: program.text("import_format"),
    unit: program.text("import_unit"),
    notes: program.json("import_notes"),
    doubtful: program.number("import_is_doubtful") === 1,
    leftOpen: () => JSON.parse(asked("import_left_open")),
    shapes: Array.from({ length: program.number("import_count") }, shape),
  };
}
