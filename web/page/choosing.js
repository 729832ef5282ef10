// Chooses the teams of a large object in a worker during a drag, so that frames stay short. The program asks for one
// document after another, each once the one before is answered (wasm/derive/elsewhere.h).
import { begin, end } from "./work.js";

// `call` calls the program. Returns the function that asks for a choice.
export function createChoosing(call) {
  let worker;
  let asked = 0; // the document whose choice is awaited, or 0
  let busy = false; // the worker places a document, perhaps one that is no longer awaited
  let next; // the document that the worker gets then

  function answer(name, number, ...choice) {
    if (!asked || number !== asked) return;
    asked = 0;
    end();
    call(name, number, ...choice);
  }

  function fail() {
    worker?.terminate();
    worker = next = undefined;
    busy = false;
    answer("page_choice_failed", asked);
  }

  function send() {
    const message = next;
    next = undefined;
    busy = true;
    worker.postMessage(message, [message.rings.buffer]);
  }

  function startWorker() {
    const started = new Worker(new URL("choosing_worker.js", import.meta.url), { type: "module" });
    started.addEventListener("message", ({ data: { number, choice } }) => {
      if (!choice) return fail();
      busy = false;
      if (next) send();
      answer("page_take_choice", number, choice);
    });
    started.addEventListener("error", (event) => {
      event.preventDefault();
      fail();
    });
    return started;
  }

  return (number, rings, settings) => {
    if (!asked) begin();
    asked = number;
    next = { number, rings, settings };
    try {
      worker ??= startWorker();
      if (!busy) send();
    } catch {
      fail();
    }
  };
}
