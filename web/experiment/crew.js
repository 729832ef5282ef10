// The workers of an experiment, and what they are given to do.
import { underWay } from "../page/under_way.js";

class Hand {
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

// One processor is left to the page. Each worker has a memory of its own, so there are not many.
const most = () => Math.max(1, Math.min(4, (navigator.hardwareConcurrency || 2) - 1));

// Has all tasks done and gives the results (evenlift/experiment/outputs.h). A task is {set, name, title, read, method}: a
// polygon, whose text `read()` gives or fails to give, to be measured with one method, or with all if none is named. With
// `onePolygon` the results are those of one polygon by itself, and one worker is enough. `progress(done, title)` is told
// of each finished task. Ended by `signal`, it fails with the signal's reason.
export function runExperiment(tasks, options) {
  return underWay(run(tasks, options));
}

async function run(tasks, { settings, onePolygon, signal, progress }) {
  const hands = onePolygon ? 1 : Math.min(most(), Math.max(1, tasks.length));
  const crew = Array.from({ length: hands }, () => new Hand());
  const stop = (why) => crew.forEach((hand) => hand.end(why));
  signal.addEventListener("abort", () => stop(signal.reason), { once: true });
  const parts = [];
  let next = 0;
  try {
    signal.throwIfAborted();
    await Promise.all(crew.map(async (hand) => {
      const problem = await hand.ask("begin", settings);
      if (problem) throw new Error(problem);
      while (next < tasks.length) {
        const { set, name, title, read, method = "" } = tasks[next++];
        const text = await read().then((content) => ({ content }), (error) => ({ problem: error.message }));
        signal.throwIfAborted();
        parts.push(await (text.problem === undefined ? hand.ask("measure", { set, name, text: text.content, method })
          : hand.ask("refuse", { set, name, problem: text.problem })));
        progress(parts.length, title);
      }
    }));
    return await crew[0].ask("results", { parts, onePolygon });
  } finally {
    stop(new Error("ended"));
  }
}
