// Chooses the teams of a large object in a worker during a drag, so that frames stay short. The program asks for one
// document after another, each once the one before is answered (wasm/derive/derive.h).
import { Core } from "./core.js";
import { begin, end } from "./work.js";

// `call` calls the program. Returns the function that asks for a choice.
export function createChoosing(call) {
  let core;
  let asked = 0; // the document whose choice is awaited, or 0
  let busy = false; // the worker places a document, perhaps one that is no longer awaited
  let next; // the document that the worker gets then

  function answer(name, number, ...choice) {
    if (!asked || number !== asked) return;
    asked = 0;
    end();
    call(name, number, ...choice);
  }

  async function work() {
    busy = true;
    try {
      while (next) {
        const { number, rings, settings } = next;
        next = undefined;
        if (!core || core.ended) core = new Core();
        const choice = await core.ask({ command: "choose", settings }, { numbers: rings });
        answer("page_take_choice", number, new Uint8Array(choice.buffer));
      }
    } catch {
      next = undefined;
      answer("page_choice_failed", asked);
    }
    busy = false;
  }

  return (number, rings, settings) => {
    if (!asked) begin();
    asked = number;
    next = { number, rings: new Float64Array(rings.buffer), settings };
    if (!busy) work();
  };
}
