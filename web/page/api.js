import { linkedLesson } from "./address.js";
import { isLesson, unreadable } from "./lesson_text.js";
import { idle } from "./work.js";

// window.evenlift, the scripting interface (docs/page.md).

// set() writes its changes as text for the program, which checks them (settings.h). A value that is neither a number
// nor a word becomes JSON, which every setting refuses.
const lists = ["com", "overlays", "heading"];
// As the program reads them: "r=30,reach=5", "3,5:0.25-0.75", "0,0 160,0@30", "30,none", "8%".
const texts = [
  ...["robot", "no_go", "support_capacities", "slope", "weight_doubt"],
  ...["readings", "reading_error", "level_error", "readings_tilted", "tilted", "heading"],
];
// With names of any characters: "0,0:north 160,0@30:\"south west\"".
const named = ["supports", "support_names", "cargo"];

function word(value) {
  const other = typeof value === "object" || (typeof value === "string" && !/^[a-zA-Z]+$/.test(value));
  return other ? JSON.stringify(value) : String(value);
}

function quoted(name) {
  return `"${String(name ?? "")
    .replaceAll('"', '""')
    .replaceAll(/\s/g, " ")}"`;
}

function load({ at, weight, name = "" } = {}) {
  return `${written("com", at)}:${word(weight)}${name && `:${quoted(name)}`}`;
}

function support(given) {
  if (Array.isArray(given) || typeof given !== "object" || given === null) return written("com", given);
  const { at, capacity, name } = given;
  return `${written("com", at)}${capacity == null ? "" : `@${word(capacity)}`}${name ? `:${quoted(name)}` : ""}`;
}

function written(name, value) {
  if (value === null) return name === "com" ? "centroid" : "none";
  if (Array.isArray(value) && name === "supports") return value.map(support).join(" ") || "none";
  if (Array.isArray(value) && name.startsWith("readings")) return value.map(word).join(" ") || "none";
  if (Array.isArray(value) && name === "support_capacities") return value.map((load) => word(load ?? "none")).join(",");
  if (Array.isArray(value) && name === "support_names") return value.map(quoted).join(" ") || "none";
  if (Array.isArray(value) && name === "cargo") return value.map(load).join(" ") || "none";
  if (Array.isArray(value) && lists.includes(name)) return value.map(word).join(",") || "none";
  if (typeof value === "string" && named.includes(name) && /^[^\r\n]+$/.test(value)) return value;
  if (typeof value === "string" && texts.includes(name) && /^[\w=.,:+@% -]+$/.test(value)) return value;
  // JavaScript may have rounded a number this large.
  if (name === "seed" && typeof value === "number" && !Number.isSafeInteger(value)) return "rounded";
  return word(value);
}

function fail(setting, why) {
  throw new Error(`${setting}: ${why}`);
}

function lines(changes) {
  if (typeof changes !== "object" || changes === null) throw new Error("set() takes an object of settings");
  return Object.entries(changes)
    .map(([name, value]) => {
      if (!/^\w+$/.test(name)) fail(name, "unknown setting");
      return `${name}=${written(name, value)}`;
    })
    .join("\n");
}

function throwIf(problem) {
  if (problem) throw new Error(problem);
}

// Only a lesson that contains its polygon: a sample would have to be fetched.
function loadLesson(program, text, nameLesson) {
  throwIf(unreadable(text));
  const sample = program.text("page_lesson_polygon", text);
  if (sample) throw new Error(`load() opens only lessons that have a link; this one is about the sample “${sample}”`);
  throwIf(program.text("page_open_lesson", text, "", 0, 1));
  nameLesson(program.json("page_lesson_link", text).text);
}

function textOfLink(program, link) {
  const { text, problem } = program.json("page_linked_lesson", link);
  throwIf(problem);
  return text;
}

// As everywhere in state(), with the members x and y added.
function point(x, y) {
  return Object.assign([x, y], { x, y });
}

// Null if no control of that name is shown.
const place = (control) => control && { x: control.left, y: control.top, width: control.width, height: control.height };

export function createApi() {
  let program;
  let isReady = false;
  let nameLesson;
  let resolve;
  let reject;
  const ready = new Promise((yes, no) => {
    resolve = yes;
    reject = no;
  });
  ready.catch(() => {}); // else the browser would report the error twice
  const running = () => (isReady ? program : fail("evenlift", "is not ready yet: await evenlift.ready"));

  const evenlift = {
    ready,
    state: () => running().json("page_state"),
    load(text) {
      if (typeof text !== "string") throw new Error("load() takes a text: a link or a polygon");
      if (isLesson(text)) return loadLesson(running(), text, nameLesson);
      const linked = linkedLesson(text);
      if (linked && !linked.link) return loadLesson(running(), textOfLink(running(), linked.lesson), nameLesson);
      throwIf(running().text("page_load", text));
    },
    set(changes) {
      const words = lines(changes);
      throwIf(running().text("page_set", words));
    },
    link: () => running().text("page_link"),
    svg: () => running().text("page_svg"),
    text: () => running().text("page_text"),
    get frames() {
      return program ? program.number("page_frames") : 0;
    },
    idle: () => ready.then(idle),
    view: Object.freeze({
      to_screen: (x, y) => point(running().number("page_screen_x", x, y), program.number("page_screen_y", x, y)),
      to_world: (px, py) => point(running().number("page_world_x", px, py), program.number("page_world_y", px, py)),
      control: (name) => place(running().json("page_control", String(name))),
    }),
  };
  return {
    evenlift: Object.freeze(evenlift),
    // `lessonNamed` gets the link of a lesson that load() opened.
    connect(running_program, lessonNamed = () => {}) {
      program = running_program;
      nameLesson = lessonNamed;
    },
    ready() {
      isReady = true;
      resolve();
    },
    fail: reject,
  };
}
