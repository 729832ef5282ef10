// The polygon's name in file names: from its file, its sample, or the number of robots that lift it.
import { fetchJson } from "../kit/fetched.js";
import { ofThisTab, read, write } from "../page/storage.js";

const namesKey = "evenlift.names";
const mostNames = 8;
const longestKept = 20000; // letters of an outline whose name survives a reload

// Texts of one polygon have the same outline, however they are written. `own` is the outline of one (ownOutline()).
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

// { origin, name } of the documents opened last, the newest first. `origin` is the outline at that time, which the
// program still has for the open polygon, however it was edited.
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

// Without the ending, and without the part that was added when the file was saved here.
export function stemOf(file) {
  return file
    .replace(/\.[^.]*$/, "")
    .replace(/-(result|poses)$/, "")
    .replace(/-\d+-robots$/, "")
    .replace(/[\s/\\:*?"<>|\p{Cc}]+/gu, "-")
    .replace(/^[-.]+|-+$/g, "")
    .slice(0, 60);
}

// As stemOf() returns it; "" if the polygon did not come from a file.
export function openedName(program) {
  const origin = program.text("page_origin");
  return names().find((each) => each.origin === origin)?.name ?? "";
}

// Call this when a polygon was opened from a file of this name (stemOf()), or with "" without a file.
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
