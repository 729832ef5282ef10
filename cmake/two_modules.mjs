// Divides the page's program into two modules of WebAssembly: the functions that its first picture needs, and the
// others, which the page loads afterwards (web/page/two_modules.js).
//   node two_modules.mjs WASM_SPLIT SCRIPT MODULE REST ASSETS WORK
// WASM_SPLIT is the tool of that name, which comes with Emscripten; it divides a module by a profile of the functions
// that were called. So that there is no list to keep, each build records the profile: it opens the page here, without a
// screen. SCRIPT is what Emscripten wrote for the page. Its MODULE is replaced by the first part, the others go to REST;
// ASSETS is the project's folder of that name, WORK one for files in between.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [wasmSplit, script, program, rest, assets, work] = process.argv.slice(2);

// What wasm-split may find and use: all browsers of the page have it.
const features = ["mutable-globals", "nontrapping-float-to-int", "sign-ext", "bulk-memory"];
const split = (...options) => execFileSync(wasmSplit, [...features.map((name) => `--enable-${name}`), ...options]);

// The opening sample on two screens and within another page, and links: their settings have functions of their own.
const starts = [
  {},
  { width: 390, height: 844, dark: 1, touch: 1 },
  { language: "de" },
  { embed: 1 },
  { link: "1.none" }, // is refused
  { sample: "gear", set: ["teams=6", "weight=800"] },
  { sample: "gear", set: ["teams=6", "weight=800"], kept: true }, // opened from the browser's storage
  { sample: "gear", set: ["metric=circle", "teams=6", "unit=mm", "overlays=candidates,tilt"] },
  { sample: "guitar", set: ["metric=distance", "com_radius=3", "capacity=40"] },
  { sample: "letter-k", set: ["com_radius=20"] },
  { sample: "anchor", set: ["metric=distributed", "teams=5", "weight_unit=lb"] },
  { sample: "horseshoe", set: ["metric=balanced", "robots=5"] },
  { sample: "hexagon", set: ["metric=balanced", "robots=6", "goal=hold", "survive=1"] },
  { sample: "anchor", set: ["metric=distributed", "unit=mm"] },
  { sample: "h-column", set: ["robot=r=20,reach=3", "no_go=2"] },
  { sample: "guitar", set: ["robot=r=5,reach=3", "no_go=3", "teams=4"] },
  { sample: "hexagon", set: ["supports=250,67@60 750,67 1000,500", "cargo=500,500:20:box"] },
  { sample: "hexagon", set: ["supports=250,67 750,67 1000,500 250,933", "slope=5%", "com_height=80"] },
  { sample: "hexagon", set: ["supports=250,67 750,67 1000,500 250,933", "give=1", "uneven=0.5", "extra=5"] },
];

// As much of a browser as the script needs before the first picture. The canvas draws nothing, and each look at the
// clock takes a millisecond, so that each build does the same.
let clock = 0;
const answers = {
  getParameter: (name) => ({ 0x1f02: "WebGL 2.0", 0x8b8c: "WebGL GLSL ES 3.00" })[name] ?? 4096,
  getProgramParameter: () => 1,
  getShaderParameter: () => 1,
};
const webgl = new Proxy({}, { get: (_, name) => answers[name] ?? (() => ({})) });
const listens = { addEventListener() {}, removeEventListener() {} };
const canvas = {
  ...listens,
  width: 1280,
  height: 800,
  style: {},
  getBoundingClientRect: () => ({ left: 0, top: 0, width: 1280, height: 800 }),
  getContext: () => webgl,
};
const browser = {
  ...listens,
  devicePixelRatio: 1,
  document: { ...listens, body: canvas, querySelector: () => canvas },
  innerHeight: 800,
  innerWidth: 1280,
  performance: { now: () => (clock += 1) },
  screen: { width: 1280, height: 800 },
  WebGLRenderingContext: class {},
};
for (const [name, value] of Object.entries({ ...browser, window: browser }))
  Object.defineProperty(globalThis, name, { value, configurable: true });

const file = (name) => path.join(work, name);
let createModule, instrumented; // for openPage()

// A page: its exports, and a function that calls one with texts and numbers.
async function openPage() {
  let exports;
  const module = await new Promise((done, fail) => {
    const instantiateWasm = (imports, receive) => {
      const received = (instance) => ((exports = instance.exports), receive(instance, instrumented));
      WebAssembly.instantiate(instrumented, imports).then(received).catch(fail);
      return {};
    };
    const bindings = new Proxy({}, { get: () => () => {} });
    createModule({ canvas, bindings, instantiateWasm }).then(done, fail);
  });
  const passed = (value) => {
    if (typeof value !== "string") return value;
    const size = module.lengthBytesUTF8(value) + 1;
    const at = module._malloc(size);
    module.stringToUTF8(value, at, size);
    return at;
  };
  const call = (name, ...given) => module[`_${name}`](...given.map(passed));
  const text = (name, ...given) => module.UTF8ToString(call(name, ...given));
  const check = (name, ...given) => {
    const refusal = text(name, ...given);
    if (refusal) throw new Error(`${name}(${given}): ${refusal}`);
  };
  return { exports, call, text, check };
}

const words = (language) => JSON.parse(readFileSync(path.join(assets, "words", `${language}.json`), "utf8"));

async function linkOf({ sample, set, link = "" }) {
  if (!sample) return link;
  const { text, check } = await openPage();
  check("page_start", "", "", "", 0);
  check("page_load", readFileSync(path.join(assets, "polygons", `${sample}.txt`), "utf8"));
  check("page_set", set.join("\n"));
  return text("page_link");
}

// The functions called until the first picture.
async function record({ link, width = 1280, height = 800, dark = 0, touch = 0, embed = 0, language, kept = false }) {
  const { exports, call, text } = await openPage();
  // What the page calls (web/page/page.js).
  if (language)
    for (const [english, translated] of Object.entries(words(language))) call("words_translate", english, translated);
  call("page_draws");
  text("page_without_step", link);
  const refusal = text("page_start", kept ? "" : link, kept ? link : "", "", embed);
  call("page_notice", refusal || "A notice.", 1);
  for (const name of [
    "page_draft",
    "page_drawing",
    "page_link",
    "page_news",
    "page_script",
    "page_summary",
    "page_task_is_open",
    "page_text",
    "page_vertex_count",
    "page_wake",
    "page_walkthrough_is_open",
  ])
    call(name);
  call("page_keep", text("page_kept"));
  call("page_preferences", dark, 0, touch);
  for (let frame = 0; frame < 4; ++frame) {
    call("page_catch_up");
    call("page_press", 0, 1);
    call("page_resize", width, height, 1, width, height);
    call("page_frame");
    call("page_zoom");
  }
  if (call("page_frames") < 4) throw new Error("the page drew nothing");
  const memory = Object.values(exports).find((value) => value instanceof WebAssembly.Memory);
  const room = 16; // pages, of 65,536 bytes; a function takes four
  const at = memory.buffer.byteLength;
  memory.grow(room);
  const size = exports.__write_profile(at, room << 16);
  return new Uint8Array(memory.buffer, at, size);
}

async function divide() {
  mkdirSync(work, { recursive: true });
  copyFileSync(script, file("script.mjs"));
  split("--instrument", program, "-o", file("instrumented.wasm"));
  ({ default: createModule } = await import(pathToFileURL(file("script.mjs"))));
  instrumented = await WebAssembly.compile(readFileSync(file("instrumented.wasm")));

  const profiles = [];
  for (const start of starts) {
    profiles.push(file(`profile-${profiles.length}`));
    writeFileSync(profiles.at(-1), await record({ ...start, link: await linkOf(start) }));
  }
  split("--merge-profiles", ...profiles, "-o", file("profile"));
  // So that modules of different versions cannot be joined, the names by which they share functions have a hash.
  const version = createHash("sha256").update(readFileSync(program)).digest("hex").slice(0, 16);
  split(
    `--profile=${file("profile")}`,
    `--placeholder-namespace=placeholder-${version}`,
    `--import-namespace=primary-${version}`,
    "--export-prefix=%",
    program,
    "-o1",
    file("first.wasm"),
    "-o2",
    rest,
  );
  checkJoint(version, file("first.wasm"), rest);
  renameSync(file("first.wasm"), program);
}

// Another version of wasm-split may name or share things in another way (web/page/two_modules.js).
function checkJoint(version, ...files) {
  const [one, other] = files.map((name) => new WebAssembly.Module(readFileSync(name)));
  const exports = WebAssembly.Module.exports(one);
  const named = new Set(exports.map(({ name }) => name));
  for (const { module, name } of WebAssembly.Module.imports(other))
    if (module !== `primary-${version}` || !named.has(name))
      throw new Error(`the second module asks for ${module} ${name}`);
  const spaces = new Set(WebAssembly.Module.imports(one).map(({ module }) => module));
  if (![...spaces].some((name) => name.startsWith(`placeholder-${version}`)))
    throw new Error(`no placeholders: ${[...spaces]}`);
  if (exports.filter(({ kind }) => kind === "table").length !== 1) throw new Error("the modules share not one table");
}

// Without wasm-split, or if it or Emscripten's script is another than expected, the program stays one module: the page
// works, but its first picture comes later, and tests fail. The second module is then empty and never loaded.
try {
  await divide();
} catch (error) {
  console.warn(`evenlift: the page's program was not divided: ${error.message}`);
  writeFileSync(rest, Uint8Array.of(0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0));
}
