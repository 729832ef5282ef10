// Comes first in our programs for Node.

// Emscripten 3.1.6 takes Node's own `fetch` for a browser's and asks it for a file. Hidden here, the file is read.
var fetch;

// A pipe that somebody made non-blocking answers EAGAIN where it should wait; Emscripten would lose the rest.
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
