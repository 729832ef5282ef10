// WebAssembly modules of the core that compute beside the page's own module.
import { Program } from "../page/program.js";
import { translations } from "../words/words.js";
import { underWay } from "../page/under_way.js";

// Returns a function that resolves with the module as a Program. `load` imports it when it is first needed. If that
// fails, or if the module stops, the next call starts again. A module that cannot be loaded rejects with an Error that
// says so.
export function coreModule(load) {
  let starting;
  const forget = () => {
    starting = undefined;
  };
  async function start() {
    const module = await load()
      .then(({ default: createModule }) => createModule())
      .catch(() => {
        throw new Error("the server cannot be reached");
      });
    const program = new Program(module);
    program.onStop = forget;
    program.speak(translations());
    return program;
  }
  return () => {
    if (!starting) {
      starting = underWay(start());
      starting.catch(forget);
    }
    return starting;
  };
}
