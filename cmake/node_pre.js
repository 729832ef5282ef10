// Precedes all other code in our programs for Node.

// Emscripten 3.1.6 mistakes Node's own `fetch` for a browser's. Hidden here, it makes Emscripten read the file instead.
var fetch;

// A pipe in non-blocking mode returns EAGAIN instead of waiting; Emscripten would lose the rest.
(() => {
  const fs = require("fs");
  const pause = new Int32Array(new SharedArrayBuffer(4));
  for (const name of ["readSync", "writeSync"]) {
    const once = fs[name];
    fs[name] = (...args) => {
      for (;;) {
        try {
          return once(...args);
        } catch (error) {
          if (error.code !== "EAGAIN") throw error;
          Atomics.wait(pause, 0, 0, 2);
        }
      }
    };
  }
})();
