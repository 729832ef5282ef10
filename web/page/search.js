// Searches for balanced robots in a worker, or without workers in slices between frames. If the start is quick, the
// page has already shown it; better results replace it. If a capacity is set, the worker computes instead the number of
// robots needed when any one may fail, which cannot be sliced.
import { Program } from "./program.js";
import { search } from "./search_loop.js";
import { begin, end } from "./work.js";

const slice = 8; // milliseconds, without a worker

// `call` calls the program. begin() ends any search under way.
export function createSearch(call) {
  let worker;
  let withoutWorker = typeof Worker !== "function";
  let wanted = 0; // the number of the search under way, or 0
  let problem;
  let starting = false; // the worker computes the start, and receives no messages

  function over() {
    if (!wanted) return;
    wanted = 0;
    if (starting) {
      worker?.terminate();
      worker = undefined;
      starting = false;
    }
    end();
  }

  function found(number, robots, ended) {
    if (number !== wanted) return;
    starting = false;
    call("page_take_robots", number, robots, ended ? 1 : 0);
    if (ended && number === wanted) over();
  }

  function failed(number) {
    if (number !== wanted) return;
    call("page_search_failed", number);
    over();
  }

  async function inSlices(number) {
    if (/^capacity=/m.test(problem.settings)) return over();
    const goesOn = () => wanted === number;
    try {
      const { default: createModule } = await import("./background_core.js");
      const program = new Program(await createModule());
      if (goesOn()) await search(program, problem, { slice, goesOn, found: (...given) => found(number, ...given) });
    } catch {
      failed(number);
    }
  }

  function startWorker() {
    const started = new Worker(new URL("search_worker.js", import.meta.url), { type: "module" });
    started.addEventListener("message", ({ data: { number, robots, ended, failed: no } }) =>
      no ? failed(number) : found(number, robots, ended),
    );
    started.addEventListener("error", (event) => {
      event.preventDefault();
      withoutWorker = true;
      worker = undefined;
      if (wanted) inSlices(wanted);
    });
    return started;
  }

  function ask(number) {
    if (!withoutWorker) {
      try {
        worker ??= startWorker();
        starting = problem.robots === "";
        return worker.postMessage({ number, problem });
      } catch {
        withoutWorker = true;
      }
    }
    return inSlices(number);
  }

  return {
    begin(number, polygon, settings, robots) {
      over();
      begin();
      wanted = number;
      problem = { polygon, settings, robots };
      ask(number);
    },
    end() {
      over();
      worker?.postMessage({ number: 0 });
    },
  };
}
