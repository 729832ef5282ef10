// The core without the view, in workers. Each has one request at a time, as JSON (docs/requests.md and
// wasm/modules/kinds.h); a request that is no longer wanted ends with its worker.

import { translations } from "../words/words.js";
import { underWay } from "./under_way.js";

// Compiled once, also for the windows, which have their own copy of this module.
const shared = Symbol.for("evenlift core");
function compiled() {
  const loading = (globalThis[shared] ??= compile());
  loading.catch(() => delete globalThis[shared]);
  return loading;
}

async function compile() {
  const answer = await fetch(new URL("core.wasm", import.meta.url)).catch(() => undefined);
  if (!answer?.ok) throw new Error("the server cannot be reached");
  return WebAssembly.compile(await answer.arrayBuffer()); // whatever type the server declares
}

// Half a surrogate pair has no place in JSON.
const asJson = (request) =>
  JSON.stringify(request, (_, value) =>
    typeof value === "string" ? value.replace(/\p{Surrogate}/gu, "\ufffd") : value,
  );

export class Core {
  #starting;
  #worker;
  #waiting = []; // questions, the first of which the worker answers
  #ended;

  // Resolves with the answer. `numbers` are a Float64Array that is passed on; with them, the answer is such an array.
  // `progress` gets the results before the answer. Rejects with an Error that gives the reason.
  async ask(request, { numbers, progress } = {}) {
    if (this.#ended) throw this.#ended;
    this.#starting ??= this.#start();
    await this.#starting;
    return new Promise((done, fail) => {
      if (this.#ended) return fail(this.#ended);
      this.#worker.postMessage({ request: asJson(request), numbers }, numbers ? [numbers.buffer] : []);
      this.#waiting.push({ done, fail, progress });
    });
  }

  async #start() {
    try {
      if (typeof Worker !== "function") throw new Error("this browser has no workers");
      const module = await compiled();
      if (this.#ended) throw this.#ended;
      this.#worker = new Worker(new URL("core_worker.js", import.meta.url));
      this.#worker.addEventListener("message", ({ data }) => this.#take(data));
      this.#worker.addEventListener("error", (event) => {
        event.preventDefault();
        this.end(new Error(event.message || "the server cannot be reached"));
      });
      this.#worker.postMessage({ module });
    } catch (error) {
      this.end(error);
      throw this.#ended;
    }
  }

  #take({ progress, answer, numbers, stopped }) {
    if (stopped) return this.end(new Error(stopped));
    if (progress) return this.#waiting[0]?.progress?.(JSON.parse(progress));
    const { done, fail } = this.#waiting.shift();
    const given = JSON.parse(answer);
    if (given.problem !== undefined || given.error) fail(new Error(given.problem ?? given.error.message));
    else done(numbers ?? given);
  }

  // Ends the worker and rejects what it was asked.
  end(why = new Error("ended")) {
    this.#ended ??= why;
    this.#worker?.terminate();
    for (const { fail } of this.#waiting.splice(0)) fail(this.#ended);
  }

  get ended() {
    return this.#ended !== undefined;
  }
}

// A worker that says sentences in the reader's language.
export function speakingCore() {
  const core = new Core();
  const words = Object.fromEntries(translations());
  core.ask({ command: "speak", words }).catch(() => {}); // the next question fails as well
  return core;
}

// Answers one request in a worker of its own; `signal` may abort it, and `progress` gets the results before the answer.
export function askOnce(request, signal, progress) {
  return underWay(ask(request, signal, progress));
}

async function ask(request, signal, progress) {
  const core = speakingCore();
  const stop = () => core.end(signal.reason);
  signal?.addEventListener("abort", stop, { once: true });
  try {
    signal?.throwIfAborted();
    return await core.ask(request, { progress });
  } finally {
    signal?.removeEventListener("abort", stop);
    core.end();
  }
}
