// Workers that measure an experiment's polygons.
import { translations } from "../words/words.js";
import { underWay } from "../page/under_way.js";

// Answers its questions in their order.
class PooledWorker {
  #worker;
  #waiting = new Map();
  #last = 0;
  #ended;

  constructor() {
    this.#worker = new Worker(new URL("experiment_worker.js", import.meta.url), { type: "module" });
    this.#worker.addEventListener("message", ({ data: { id, answer, problem } }) => {
      const { done, fail } = this.#waiting.get(id);
      this.#waiting.delete(id);
      if (problem === undefined) done(answer);
      else fail(new Error(problem));
    });
    this.#worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.end(new Error(event.message || "the server cannot be reached"));
    });
    this.ask("speak", { words: translations() }).catch(() => {}); // the next question fails as well
  }

  ask(task, given) {
    return new Promise((done, fail) => {
      if (this.#ended) return fail(this.#ended);
      this.#waiting.set(++this.#last, { done, fail });
      this.#worker.postMessage({ id: this.#last, task, ...given });
    });
  }

  end(why) {
    this.#ended ??= why;
    this.#worker.terminate();
    for (const { fail } of this.#waiting.values()) fail(why);
    this.#waiting.clear();
  }
}

// Answers one task in a separate worker; `signal` may abort it.
export function askWorker(task, given, signal) {
  return underWay(askOne(task, given, signal));
}

async function askOne(task, given, signal) {
  const worker = new PooledWorker();
  signal.addEventListener("abort", () => worker.end(signal.reason), { once: true });
  try {
    signal.throwIfAborted();
    return await worker.ask(task, given);
  } finally {
    worker.end(new Error("ended"));
  }
}

// One processor is left to the page. Each worker has its own memory, so there are at most four.
const most = () => Math.max(1, Math.min(4, (navigator.hardwareConcurrency || 2) - 1));

// Returns the results of all tasks (evenlift/experiment/outputs.h). A task is {set, name, title, read, method}: a
// polygon, measured with one method, or without `method` with all. `read()` returns the polygon's text or fails. With
// `onePolygon`, one worker is enough for all tasks; `partly(results)` then gets the results before the last task, which
// may take long. `progress(done, title)` is called after each task. If `signal` aborts, the call fails with its reason.
export function runExperiment(tasks, options) {
  return underWay(run(tasks, options));
}

async function run(tasks, { settings, onePolygon, signal, progress, partly }) {
  const size = onePolygon ? 1 : Math.min(most(), Math.max(1, tasks.length));
  const pool = Array.from({ length: size }, () => new PooledWorker());
  const stop = (why) => pool.forEach((worker) => worker.end(why));
  signal.addEventListener("abort", () => stop(signal.reason), { once: true });
  const parts = [];
  let next = 0;
  try {
    signal.throwIfAborted();
    await Promise.all(
      pool.map(async (worker) => {
        const problem = await worker.ask("begin", settings);
        if (problem) throw new Error(problem);
        while (next < tasks.length) {
          if (onePolygon && next > 0 && next === tasks.length - 1)
            await partly(await worker.ask("results", { parts, onePolygon }));
          const { set, name, title, read, method = "" } = tasks[next++];
          const text = await read().then(
            (content) => ({ content }),
            (error) => ({ problem: error.message }),
          );
          signal.throwIfAborted();
          parts.push(
            await (text.problem === undefined
              ? worker.ask("measure", { set, name, text: text.content, method })
              : worker.ask("refuse", { set, name, problem: text.problem })),
          );
          progress(parts.length, title);
        }
      }),
    );
    return await pool[0].ask("results", { parts, onePolygon });
  } finally {
    stop(new Error("ended"));
  }
}
