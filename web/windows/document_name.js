// The name of the open polygon in file names: from the file from which it came, from its sample, or from the number of
// robots that lift it.
import { fetchJson } from "../kit/fetched.js";
import { ofThisTab, read, write } from "../page/storage.js";

const namesKey = "evenlift.names";
const mostNames = 8;
const longestKept = 20000; // letters of an outline whose name survives a reload

// Two texts of the same polygon give the same outline, however they are written. `own` is the outline of one of them
// (ownOutline()).
export function isSame(program, text, own) {
  const vertices = (each) =>
    each
      .trimEnd()
      .split("\n")
      .filter((line) => !/^(com|#)/i.test(line.trim())).length;
  return vertices(text) === own.vertices && program.text("page_outline", text) === own.outline;
}

export const ownOutline = (program) => ({
  outline: program.text("page_outline", program.text("page_text")),
  vertices: program.number("page_vertex_count"),
});

// --- Opened files ----------------------------------------------------------------------------------------------------

// The documents opened last, the newest first, as { origin, name }. `origin` is the outline that the document had then;
// the program still has it for the open polygon, however it was edited since.
let named;

function names() {
  if (!named) {
    try {
      named = JSON.parse(read(ofThisTab, namesKey) || "[]");
    } catch {
      named = [];
    }
  }
  return named;
}

// A file's name without its ending, and without the part that was added when it was saved here.
export function stemOf(file) {
  return file
    .replace(/\.[^.]*$/, "")
    .replace(/-(result|poses)$/, "")
    .replace(/-\d+-robots$/, "")
    .replace(/[\s/\\:*?"<>|\p{Cc}]+/gu, "-")
    .replace(/^[-.]+|-+$/g, "")
    .slice(0, 60);
}

// The name of the file from which the open polygon came, as stemOf() returns it; "" if it did not come from a file.
export function openedName(program) {
  const origin = program.text("page_origin");
  return names().find((each) => each.origin === origin)?.name ?? "";
}

// Call this when a polygon was just opened from a file with this name (stemOf()), or with "" if there was no file.
export function nameOpened(program, name) {
  const origin = program.text("page_origin");
  if (!origin) return;
  named = [{ origin, name }, ...names().filter((each) => each.origin !== origin)].slice(0, mostNames);
  write(ofThisTab, namesKey, JSON.stringify(named.filter((each) => each.name && each.origin.length < longestKept)));
}

export async function documentName(program) {
  const robots = JSON.parse(program.text("page_state")).teams.flatMap(({ loads }) => loads).length;
  const opened = openedName(program);
  const samples = await fetchJson("polygons.json").catch(() => ({}));
  const own = ownOutline(program);
  const sample = Object.keys(samples).find((name) => isSame(program, samples[name], own));
  return sample && (!opened || opened === sample) ? sample : `${opened || "polygon"}-${robots}-robots`;
}
