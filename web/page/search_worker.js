// The worker of search.js.
import createModule from "./background_core.js";
import { Program } from "./program.js";
import { search } from "./search_loop.js";

const slice = 50; // milliseconds, after which the worker listens
const started = createModule().then((module) => new Program(module));
let wanted = 0; // the number of the current search, or 0

addEventListener("message", async ({ data: { number, problem } }) => {
  wanted = number;
  if (!number) return;
  const goesOn = () => wanted === number;
  try {
    const program = await started;
    if (goesOn())
      await search(program, problem, {
        slice,
        goesOn,
        found: (robots, ended) => postMessage({ number, robots, ended }),
      });
  } catch {
    postMessage({ number, failed: true });
  }
});
