// The worker of core.js: gets the compiled core, then requests. It is no module, since Firefox has had workers that are
// modules only since version 114.
"use strict";
let core;

const textAt = (at) => {
  const bytes = new Uint8Array(core.memory.buffer);
  return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
};

// Other functions of the host are never needed: it has no files, and what calls them has stopped.
function start(module) {
  const host = {
    now: () => performance.now(),
    report: (at) => postMessage({ progress: textAt(at) }),
    emscripten_notify_memory_growth: () => {},
  };
  const given = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module))
    (given[from] ??= {})[name] =
      host[name] ??
      (() => {
        throw new WebAssembly.RuntimeError(name);
      });
  core = new WebAssembly.Instance(module, given).exports;
  core._initialize?.();
}

function answer(request, numbers) {
  const bytes = new TextEncoder().encode(request);
  const at = core.evenlift_room(bytes.length + 1);
  if (!at) throw new WebAssembly.RuntimeError();
  new Uint8Array(core.memory.buffer, at, bytes.length).set(bytes);
  if (numbers) {
    const room = core.evenlift_numbers(numbers.length);
    new Float64Array(core.memory.buffer, room, numbers.length).set(numbers);
  }
  const found = core.evenlift_answer_page(at, bytes.length);
  core.evenlift_free(at);
  if (!found) throw new WebAssembly.RuntimeError();
  const text = textAt(found);
  core.evenlift_free(found);
  if (!numbers) return postMessage({ answer: text });
  const from = core.evenlift_numbers_at();
  const copy = new Float64Array(core.memory.buffer.slice(from, from + 8 * core.evenlift_numbers_count()));
  postMessage({ answer: text, numbers: copy }, [copy.buffer]);
}

addEventListener("message", ({ data: { module, request, numbers } }) => {
  try {
    if (module) start(module);
    else answer(request, numbers);
  } catch (error) {
    // What traps in the core is memory that is too low.
    postMessage({ stopped: error instanceof WebAssembly.RuntimeError ? "There is not enough memory" : error.message });
  }
});
