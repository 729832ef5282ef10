import { lessonLinkIn, linkIn, readAddress } from "./address.js";
import { lowered, say, translated, translations } from "../words/words.js";
import { createApi } from "./api.js";
import { Bindings } from "./bindings.js";
import { connectInput } from "./input.js";
import { speak } from "./language.js";
import { loadProgram, NotLoaded } from "./program.js";
import { Publisher } from "./publisher.js";
import { beginStart, prepareRestart, whyStartedAnew, workGoesOn } from "./recovery.js";
import { connectScreen } from "./screen.js";
import { lasting, read } from "./storage.js";
import { underWay } from "./under_way.js";

const cover = document.getElementById("cover");
const { embed, challenge, lesson: askedLesson, place } = readAddress();
const api = createApi();
window.evenlift = api.evenlift;
if (embed) document.documentElement.classList.add("figure", "guest"); // input.js

const noWebAssembly = "evenlift needs WebAssembly. This browser does not have it, or it is switched off.";
const noWebGl = "evenlift draws with WebGL 2. This browser does not have it, or it is switched off.";
const whereItRuns =
  "A current Firefox, Chrome, Edge or Safari with graphics acceleration switched on can run the page. " +
  "The link in the address bar holds everything: there it opens the same document.";

const cannotRun = ["The page cannot run here.", whereItRuns];
const isIncomplete = [
  "The page could not be loaded completely.",
  "Nothing that was drawn is lost. Reload the page as soon as there is a network.",
];
const hasStopped = ["The page has stopped.", "Nothing that was drawn is lost. Reload the page to continue."];

function showProblem(reason, [heading, advice] = cannotRun) {
  document.getElementById("progress").hidden = true;
  const problem = document.getElementById("problem");
  const strong = document.createElement("strong");
  strong.textContent = translated(heading);
  problem.replaceChildren(
    strong,
    ...[reason, advice].map((text) => Object.assign(document.createElement("p"), { textContent: translated(text) })),
  );
  problem.hidden = false;
  cover.classList.add("told");
  cover.classList.remove("done", "see-through");
}

// A challenge starts at its first step: the link's step would show the answer and list it among the answers looked at.
// A challenge to place robots opens with robots to place.
function toOpen(program, text) {
  const asked = readAddress();
  if (asked.place) return program.text("page_as_challenge", text, asked.place);
  return asked.challenge && text ? program.text("page_without_step", text) : text;
}

// `tell` gets the message about a refused link; `opened` is called after any other.
function followAddress(program, tell, opened) {
  addEventListener("hashchange", () => {
    const link = linkIn(location.hash);
    if (!link) return void (lessonLinkIn(location.hash) && opened(false));
    const problem = program.text("page_open_link", toOpen(program, link));
    if (problem) tell(`${refused(problem)} ${translated("Nothing was changed.")}`);
    else opened(true);
  });
}

// When the page shows something else in its place.
function refusedAtStart(problem, { work } = {}) {
  const instead = work ? "The page shows the last document instead." : "The page shows a sample instead.";
  return `${refused(problem)} ${translated(instead)}`;
}

// The reason may name its place, which is the link.
function refused(problem) {
  return say("This link cannot be opened: {problem}.", { problem: lowered(problem.replace(/^Link, /, "")) });
}

async function load(bindings) {
  const program = await loadProgram({ canvas: document.getElementById("canvas"), bindings });
  program.speak(translations());
  bindings.attach(program);
  return program;
}

// Loaded after the first frame, which does not need the controls in HTML. Returns the function to call after each
// frame.
async function loadMirror(program, field, publisher) {
  const style = Object.assign(document.createElement("link"), { rel: "stylesheet", href: "mirror.css" });
  const styled = new Promise((done, fail) => Object.assign(style, { onload: done, onerror: fail }));
  document.body.append(style);
  const [{ createMirror }] = await Promise.all([import("./mirror.js"), styled]);
  return createMirror(program, field, (text, problem) => publisher.notice(text, problem));
}

// Returns a function that says whether the user has begun to work.
function firstTouch() {
  let touched = false;
  for (const type of ["pointerdown", "keydown", "drop", "paste", "hashchange"])
    addEventListener(type, () => (touched = true), { once: true, capture: true, passive: true });
  return () => touched;
}

// For visitors who may be new to evenlift: one line, until the first touch.
function introduce(program) {
  program.call(
    "page_notice",
    "You see an object from above, and the robots that lift it. Drag a robot, a corner or the centre of mass.",
    2, // a hint, not a success
  );
  const ends = () => program.call("page_end_notice");
  for (const type of ["pointerdown", "keydown"])
    addEventListener(type, ends, { once: true, capture: true, passive: true });
}

// To visitors who may be new to evenlift, if nothing but a language is asked for.
const isFirst = () => /^(\?lang=\w*)?$/.test(location.search) && !read(lasting, "evenlift.welcomed");

// What was pressed on the cover (cover.js) happens now. A click is passed on as the mouse's, at its place.
function pass(pressed) {
  const canvas = document.getElementById("canvas");
  for (const event of pressed) {
    if (event instanceof KeyboardEvent) {
      canvas.dispatchEvent(new KeyboardEvent(event.type, event));
      continue;
    }
    const { clientX, clientY } = event;
    for (const [type, buttons] of Object.entries({ mousemove: 0, mousedown: 1, mouseup: 0 })) {
      const options = { clientX, clientY, buttons, detail: 1, bubbles: true, cancelable: true };
      canvas.dispatchEvent(new MouseEvent(type, options));
    }
  }
}

// The first visit's card is in the HTML until its window is loaded, which then does what was pressed on it.
async function welcome(bindings, pressed) {
  const first = document.getElementById("first");
  const ways = [...first.querySelectorAll("button")];
  let way = ways.findIndex((button) => button.contains(pressed?.target));
  ways.forEach((button, i) => {
    button.addEventListener("click", () => {
      ways[way]?.classList.remove("pressed");
      way = i;
      button.classList.add("pressed");
    });
  });
  await bindings.openDialog("firstVisit");
  first.remove();
  document.querySelectorAll("#welcome .ways button")[way]?.click();
}

let started; // by beginStart()

// After the first frame, when the user can begin.
function loadTheRest(program, bindings, { begins, introduces, pressed }) {
  for (const type of ["pointerdown", "keydown"]) addEventListener(type, workGoesOn, { capture: true, passive: true });
  if (embed) return;
  // Without this module, undo starts empty.
  underWay(import("./kept_history.js").then(({ keepHistory }) => keepHistory(program)).catch(() => {}));
  underWay(import("./offline.js"))
    .then(({ keepForOffline }) => keepForOffline(() => bindings.openDialog("newVersion")))
    .catch(() => {});
  if (introduces && isFirst()) introduce(program);
  if (begins) underWay(welcome(bindings, pressed));
}

// Without WebGL 2 the link's polygon is a still picture. The kept work of other visits stays unchanged. Returns the
// function to call after each change.
async function startStill(program, publisher, bindings) {
  // The picture would give away a challenge's answer.
  const still = !challenge && !place && (await import("./still.js").catch(() => undefined));
  if (!still) throw new Error(noWebGl);
  program.onStop = (error) => {
    console.error(error);
    showProblem("Something went wrong while drawing.", hasStopped);
  };
  publisher.keepNothing();
  publisher.holdLesson(true); // lessons need the canvas; the address still names its own
  const problem = program.text("page_start", linkIn(location.hash), "", "", embed ? 1 : 0);
  api.connect(program);
  publisher.connect(program);
  bindings.connect(program, undefined, { embed: true });
  const { draw, tell } = await still.showStill(program, {
    missing: [noWebGl, whereItRuns],
    save: embed ? undefined : () => bindings.openDialog("save"),
  });
  if (problem) tell(refusedAtStart(problem));
  followAddress(program, tell, () => tell(""));
  draw();
  return draw;
}

async function start() {
  await speak();
  if (typeof WebAssembly !== "object") throw new Error(noWebAssembly);
  const publisher = new Publisher({ embed });
  let afterPicture;
  let pictureIsThere;
  const firstPicture = new Promise((done) => {
    pictureIsThere = done;
  });
  // `awaited` names the field that a key asked for, until the mirror has it; `begun` is that key if it is a digit.
  // `show` updates the mirror.
  const field = { awaited: "", begun: "", show: () => {} };
  let hasBegun = false; // frames before the start draw nothing
  const bindings = new Bindings(publisher, field, () => {
    if (!hasBegun) return;
    pictureIsThere();
    publisher.drawn();
    program.onPicture();
    afterPicture?.();
    opening = "";
  });
  let opening = "";
  const program = await load(bindings);
  if (!program.number("page_draws")) {
    hasBegun = true;
    afterPicture = await startStill(program, publisher, bindings);
    document.getElementById("first").remove();
    window.pressedOnCover?.();
    cover.classList.add("done");
    return api.ready();
  }
  const fragment = linkIn(location.hash);
  const kept = publisher.kept(fragment);
  const lesson = lessonLinkIn(location.hash);
  const asked = { ...kept, fragment: kept.own ? "" : fragment, lesson };
  started = embed ? asked : await beginStart(asked);
  const stopped = new Promise((_, fail) => {
    program.onStop = fail;
  });
  stopped.catch(() => {});
  // For exceptions in SDL's own event handlers, which call the program.
  addEventListener("error", ({ error }) => {
    if (error instanceof WebAssembly.RuntimeError) program.stop(error);
  });
  if (!embed && kept.work !== started.work) publisher.forget(kept.work);
  api.connect(program, (name) => publisher.nameLesson(name));
  // If the link is the document that was last open here, no step leads to it.
  const before = started.work === started.fragment ? "" : started.work;
  hasBegun = true;
  const problem = program.text(
    "page_start",
    started.fragment || !before ? toOpen(program, started.fragment) : "",
    before && toOpen(program, before),
    started.draft,
    embed ? 1 : 0,
  );
  publisher.connect(program);
  publisher.restorePreferences();
  if (kept.own || started.problem) publisher.nameInAddress();
  if (!started.fragment) publisher.resumeDrawing(started.drawing);
  bindings.connect(program, connectScreen(program), { embed });
  // The picture makes room for the first visit's card from the start, as the cover does.
  const welcomes = !fragment && !lesson && !kept.work && !embed && isFirst();
  if (welcomes) program.call("page_make_room", document.getElementById("first").offsetHeight);
  connectInput(program, field, { embed });
  followAddress(
    program,
    (text) => program.call("page_notice", text, 1),
    (join) => bindings.beginLesson(join),
  );
  // If the address's document is open, its lesson continues at the link's step.
  if (started.lesson === lesson) await bindings.beginLesson(fragment !== "" && !problem && !started.problem);
  else publisher.nameInAddress();
  const message = started.problem || (problem && refusedAtStart(problem, started)) || (embed ? "" : whyStartedAnew());
  if (message) program.call("page_notice", message, 1);
  await Promise.race([firstPicture, stopped]);
  // The first frame measures the panels, and the second has the object in its place.
  await new Promise((done) => requestAnimationFrame(done));
  if (program.stopped) await stopped;
  started.succeeded?.();
  cover.classList.add("done");
  const pressed = window.pressedOnCover?.() ?? [];
  if (started.fragment && !problem) publisher.adopt(fragment);
  program.onOpening = (text) => {
    publisher.flush({ drawn: true });
    opening = text;
    workGoesOn();
  };
  program.onStop = (error) => {
    const work = publisher.stop();
    startAnew(error, { opening, work });
  };
  performance.mark("ready"); // what is loaded from here on does not delay the first picture
  const isTouched = firstTouch();
  const ofCard = (event) => event.target.closest?.("#first button");
  pass(pressed.filter((event) => !ofCard(event)));
  const begins = welcomes && pressed.every(ofCard) && !isTouched();
  if (!begins) document.getElementById("first").remove();
  if (welcomes && !begins) program.call("page_make_room", 0);
  underWay(loadMirror(program, field, publisher)).then(
    (drawn) => {
      afterPicture = drawn;
      field.show = () => {
        program.call("page_lay_out");
        drawn();
      };
      drawn();
    },
    (error) => console.warn("The controls cannot be reached by keys: they could not be loaded.", error),
  );
  loadTheRest(program, bindings, {
    begins,
    pressed: pressed.at(-1),
    introduces: fragment && !lesson && !problem && !kept.own && !pressed.length && !isTouched(),
  });
  api.ready();
}

// The page is loaded again with the last drawn document, since the program's memory cannot be trusted.
function startAnew(error, { opening, work }) {
  console.error(error);
  if (!embed && prepareRestart({ opening, work })) location.reload();
  else {
    showProblem("Something went wrong while drawing.", hasStopped);
    api.fail(error);
  }
}

function fail(error) {
  if (error instanceof NotLoaded) {
    console.error(error);
    showProblem(error.message, isIncomplete);
    return api.fail(error);
  }
  if (started?.failed?.()) {
    console.error(error);
    return location.reload(); // without the text that was being opened
  }
  showProblem(error.message);
  api.fail(error);
}

start().catch(fail);
