// The polygons on which methods are compared: the open one, the project's sets, and files. Each function returns tasks
// for the workers (worker_pool.js).
import { methods } from "../charts/methods.js";
import { fetchJson } from "../kit/fetched.js";
import { say } from "../words/words.js";

const mostBytes = 64 * 1024 * 1024; // core/include/evenlift/document.h

const nameOf = (file) => file.name.replace(/\.[^.]*$/, "") || file.name;

async function textOf(file) {
  if (file.size > mostBytes) throw new Error("it has more than the 64 MiB that evenlift reads");
  const text = await file.text().catch(() => {
    throw new Error("it cannot be read");
  });
  if (text.includes("\0")) throw new Error("it is not text");
  return text;
}

const cannotBeFetched = (what) => (error) => {
  throw new Error(say(what, { why: error.message }));
};

// One task for each method, so that progress is visible. Balanced robots take longest and are last.
export function thisPolygon({ text }) {
  return Object.keys(methods).map((method) => ({
    set: "",
    name: "this-polygon",
    title: methods[method].words,
    method,
    read: async () => text,
  }));
}

// All of assets/polygons, under the gallery's names.
export async function samples() {
  const [gallery, texts] = await Promise.all([fetchJson("samples.json"), fetchJson("polygons.json")]).catch(
    cannotBeFetched("The samples cannot be fetched: {why}"),
  );
  const titles = new Map(gallery.map(({ name, title }) => [name, title]));
  const titleOf = (name) =>
    titles.get(name) ??
    say("{title}, centre of mass moved", { title: titles.get(name.replace(/-moved$/, "")) ?? name });
  return Object.entries(texts).map(([name, text]) => ({
    set: "polygons",
    name,
    title: titleOf(name),
    read: async () => text,
  }));
}

// "Notched, 4 vertices, centre moved (1)" in the reader's language.
const inWords = (title) =>
  title
    .split(", ")
    .map((part) => say(part.replace(/\d+/, "{number}"), { number: part.match(/\d+/) }))
    .join(", ");

export async function thesisLike() {
  const all = await fetchJson("thesis-like.json").catch(cannotBeFetched("The set cannot be fetched: {why}"));
  return all.map(({ name, title, text }) => ({
    set: "thesis-like",
    name,
    title: inWords(title),
    read: async () => text,
  }));
}

// Files with the same name would count as one polygon.
export function ownFiles(files) {
  if (files.length === 0) throw new Error("Choose files first, or drop them here");
  const names = files.map(nameOf);
  const twice = names.find((name, at) => names.indexOf(name) !== at);
  if (twice !== undefined) throw new Error(say("Two files have the name “{name}”", { name: twice }));
  return files.map((file, at) => ({ set: "files", name: names[at], title: names[at], read: () => textOf(file) }));
}
