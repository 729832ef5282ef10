// Starts the page: looks whether it can run, loads the program, connects it to the browser.
import { readAddress } from "./address.js";
import { createApi } from "./api.js";
import { createHost } from "./host.js";
import { connectInput } from "./input.js";
import { Program } from "./program.js";
import { Publisher } from "./publisher.js";
import { connectScreen } from "./screen.js";

const cover = document.getElementById("cover");
const { embed } = readAddress();
const api = createApi();
window.evenlift = api.evenlift;

function missing() {
  if (typeof WebAssembly !== "object") {
    return "This browser has no WebAssembly, or it is switched off. evenlift computes with it.";
  }
  const probe = document.createElement("canvas").getContext("webgl2");
  if (!probe) {
    return "This browser offers no WebGL 2, or it is switched off. evenlift draws with it.";
  }
  probe.getExtension("WEBGL_lose_context")?.loseContext();
  return "";
}

function showProblem(reason) {
  document.getElementById("progress").hidden = true;
  const problem = document.getElementById("problem");
  const strong = document.createElement("strong");
  strong.textContent = "The page cannot run here.";
  const why = document.createElement("p");
  why.textContent = reason;
  const advice = document.createElement("p");
  advice.textContent = "A current Firefox, Chrome, Edge or Safari with graphics acceleration switched on can show it. " +
    "The link in the address bar keeps everything: it opens there as it would have here.";
  problem.replaceChildren(strong, why, advice);
  problem.hidden = false;
  cover.classList.remove("done", "see-through");
}

function followAddress(program, host) {
  addEventListener("hashchange", () => {
    const link = location.hash.slice(1);
    if (!link) return;
    const problem = program.text("page_open_link", link);
    if (problem) program.call("page_notice", `This link cannot be opened: ${lowered(problem)}. Nothing was changed.`, 1);
    else host.beginLesson(true);
  });
}

function lowered(sentence) {
  return sentence.charAt(0).toLowerCase() + sentence.slice(1);
}

async function start() {
  const reason = missing();
  if (reason) throw new Error(reason);
  const { default: createModule } = await import("./evenlift.js");
  const publisher = new Publisher({ embed });
  const host = createHost(publisher);
  const module = await createModule({
    canvas: document.getElementById("canvas"),
    host,
    onAbort: (why) => fail(new Error(`The program stopped: ${why}`)),
  });
  const program = new Program(module);
  api.connect(program);
  const fragment = location.hash.slice(1);
  const kept = publisher.kept(fragment);
  const problem = program.text("page_start", kept.own ? "" : fragment, kept.work, kept.draft, embed ? 1 : 0);
  publisher.connect(program);
  publisher.restorePreferences();
  if (kept.own) publisher.changed();
  if (kept.own || !fragment) publisher.resumeDrawing();
  host.connect(program, connectScreen(program), { embed });
  connectInput(program, { embed });
  followAddress(program, host);
  await host.beginLesson(fragment !== "" && !problem);
  if (problem) program.call("page_notice", `This link cannot be opened: ${lowered(problem)}.`, 1);
  await firstFrame(program);
}

function firstFrame(program) {
  return new Promise((done) => {
    const look = () => (program.number("page_frames") > 0 ? done() : requestAnimationFrame(look));
    look();
  });
}

function fail(error) {
  showProblem(error.message);
  api.fail(error);
}

start().then(() => {
  cover.classList.add("done");
  api.ready();
}, fail);
