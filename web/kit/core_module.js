// WebAssembly modules of the core that compute beside the page's own.
import { Program } from "../page/program.js";
import { translations } from "../words/words.js";
import { underWay } from "../page/under_way.js";

// Returns a function that resolves with the module as a Program, which `load` imports at the first use. If the module
// cannot be loaded, it rejects with an Error that says so. After that, or if the module stops, the next call starts
// again.
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
