// Workers that measure an experiment's polygons.
import { speakingCore } from "../page/core.js";
import { underWay } from "../page/under_way.js";

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
  const pool = Array.from({ length: size }, speakingCore);
  const stop = (why) => pool.forEach((core) => core.end(why));
  signal.addEventListener("abort", () => stop(signal.reason), { once: true });
  const parts = [];
  const results = (core) => core.ask({ command: "results", parts, onePolygon: onePolygon ? 1 : 0, ...settings });
  let next = 0;
  try {
    signal.throwIfAborted();
    await Promise.all(
      pool.map(async (core) => {
        while (next < tasks.length) {
          if (onePolygon && next > 0 && next === tasks.length - 1) await partly(await results(core));
          const { set, name, title, read, method = "" } = tasks[next++];
          const text = await read().then(
            (content) => ({ text: content, method }),
            (error) => ({ problem: error.message }),
          );
          signal.throwIfAborted();
          const { part } = await core.ask({ command: "measure", set, name, ...text, ...settings });
          parts.push(part);
          progress(parts.length, title);
        }
      }),
    );
    return await results(pool[0]);
  } finally {
    stop(new Error("ended"));
  }
}
