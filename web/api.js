import { isLesson, unreadable } from "./lesson_text.js";

// window.evenlift, the page's scripting interface (docs/page.md).

// What set() takes: each turns a value into a word for the program, or says what it expects.
const writers = {
  teams: (v) => v === "max" || isWhole(v) ? String(v) : fail("teams", 'must be a whole number from 1, or "max"'),
  metric: (v) => typeof v === "string" && /^[a-z]+$/.test(v) ? v : fail("metric", "must be the name of a method"),
  min_ratio: (v) => isNumber(v) ? String(v) : fail("min_ratio", "must be a number from 0 to 1"),
  weight: (v) => isNumber(v) ? String(v) : fail("weight", "must be a number above 0"),
  seed: (v) => isWhole(v) || typeof v === "bigint" ? String(v) : fail("seed", "must be a whole number from 0"),
  com: (v) => {
    if (v === null) return "centroid";
    if (!Array.isArray(v) || v.length !== 2 || !v.every(isNumber)) fail("com", "must be [x, y], or null for the centroid");
    return `${v[0]},${v[1]}`;
  },
  step: (v) => v === null ? "none" : isWhole(v) ? String(v) : fail("step", "must be a whole number from 0, or null"),
};

function isNumber(value) {
  return typeof value === "number" && Number.isFinite(value);
}

function isWhole(value) {
  return Number.isSafeInteger(value) && value >= 0;
}

function fail(setting, why) {
  throw new Error(`${setting}: ${why}`);
}

function lines(changes) {
  if (typeof changes !== "object" || changes === null) throw new Error("set() takes an object of settings");
  return Object.entries(changes).map(([name, value]) => {
    if (!Object.hasOwn(writers, name)) fail(name, "there is no such setting");
    return `${name}=${writers[name](value)}`;
  }).join("\n");
}

function throwIf(problem) {
  if (problem) throw new Error(problem);
}

// A lesson that brings its polygon along: a sample would have to be fetched.
function loadLesson(program, text) {
  throwIf(unreadable(text));
  const sample = program.text("page_lesson_polygon", text);
  if (sample) throw new Error(`load() opens lessons with a link: only; this one is about the sample “${sample}”`);
  throwIf(program.text("page_open_lesson", text, "", 0));
}

// A point both as [x, y], as everywhere in state(), and with x and y.
function point(x, y) {
  return Object.assign([x, y], { x, y });
}

export function createApi() {
  let program;
  let resolve;
  let reject;
  const ready = new Promise((yes, no) => {
    resolve = yes;
    reject = no;
  });
  ready.catch(() => {});  // who does not look at it needs no second message
  const running = () => program ?? fail("evenlift", "is not ready yet: await evenlift.ready");

  const evenlift = {
    ready,
    state: () => JSON.parse(running().text("page_state")),
    load(text) {
      if (typeof text !== "string") throw new Error("load() takes a text: a link or a polygon");
      if (isLesson(text)) return loadLesson(running(), text);
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
    view: Object.freeze({
      to_screen: (x, y) => point(running().number("page_screen_x", x, y), program.number("page_screen_y", x, y)),
      to_world: (px, py) => point(running().number("page_world_x", px, py), program.number("page_world_y", px, py)),
    }),
  };
  return {
    evenlift: Object.freeze(evenlift),
    connect(running_program) {
      program = running_program;
    },
    ready: resolve,
    fail: reject,
  };
}
