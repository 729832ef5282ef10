// The worker of choosing.js.
import createModule from "./background_core.js";
import { Program } from "./program.js";

const started = createModule().then((module) => new Program(module));

addEventListener("message", async ({ data: { number, rings, settings } }) => {
  try {
    const program = await started;
    const size = program.number("choosing_place", rings, settings);
    const choice = program.bytes("choosing_choice", size);
    postMessage({ number, choice }, [choice.buffer]);
  } catch {
    postMessage({ number });
  }
});
