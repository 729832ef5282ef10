// The package's functions: requests as JSON in, answers of its WebAssembly as JSON out.

// `message` is a sentence that includes the place; `code`, `place` and `path` give the same facts as data.
export class EvenliftError extends Error {
  name = "EvenliftError";

  constructor({ code, message, place, path }) {
    super(message);
    this.code = code;
    this.place = place;
    this.path = path;
  }
}

// The module's imports: one reports that its memory grew, the others end it. It has no files and no clock.
function hostOf(compiled) {
  const host = {};
  for (const { module, name } of WebAssembly.Module.imports(compiled)) {
    (host[module] ??= {})[name] =
      name === "emscripten_notify_memory_growth"
        ? () => {}
        : () => {
            throw new WebAssembly.RuntimeError(`evenlift cannot continue: ${name}`);
          };
  }
  return host;
}

function start(compiled) {
  const { exports } = new WebAssembly.Instance(compiled, hostOf(compiled));
  exports._initialize?.();
  return exports;
}

function textAt(memory, at) {
  const bytes = new Uint8Array(memory.buffer);
  return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
}

function answerOf({ memory, evenlift_room, evenlift_free, evenlift_answer }, request) {
  const bytes = new TextEncoder().encode(request);
  const at = evenlift_room(bytes.length + 1);
  if (!at) throw new Error("evenlift: there is not enough memory for the request");
  new Uint8Array(memory.buffer, at, bytes.length).set(bytes);
  const answer = evenlift_answer(at, bytes.length);
  evenlift_free(at);
  if (!answer) throw new Error("evenlift: there is not enough memory for the answer");
  const text = textAt(memory, answer);
  evenlift_free(answer);
  return text;
}

// --- Requests

// What JSON has no form for becomes a text, which the core refuses by its path, or takes for a number's digits.
function written(_, value) {
  if (ArrayBuffer.isView(value)) return Array.from(value);
  const isNumber = typeof value === "number" && !Number.isFinite(value);
  return isNumber || ["bigint", "function", "symbol"].includes(typeof value) ? String(value) : value;
}

const base64 = (bytes) => btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));

const textOf = (file) => (file instanceof Uint8Array ? { bytes: base64(file) } : { text: file });

function shapeOf(polygon) {
  if (typeof polygon === "string" || polygon instanceof Uint8Array) return textOf(polygon);
  const isDocument = typeof polygon === "object" && polygon !== null && !Array.isArray(polygon);
  return isDocument ? { document: polygon } : { polygon };
}

export function createApi(compiled) {
  let running = start(compiled);

  // The answer has the same bytes as the program's output. A module that stopped is replaced.
  function run(request) {
    try {
      return answerOf(running, typeof request === "string" ? request : JSON.stringify(request, written));
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      running = start(compiled);
      throw new Error("evenlift stopped: there is not enough memory for this", { cause: error });
    }
  }

  function ask(request) {
    const answer = JSON.parse(run(request));
    if (answer.error) throw new EvenliftError(answer.error);
    return answer;
  }

  const asked = (command) => (polygon, options) => ask({ ...options, command, ...shapeOf(polygon) });
  return {
    run,
    place: asked("place"),
    candidates: (...args) => asked("candidates")(...args).candidates,
    svg: (...args) => asked("svg")(...args).svg,
    poses: (...args) => asked("poses")(...args).poses,
    link: (...args) => asked("link")(...args).link,
    optimum: asked("optimum"),
    trace: (...args) => asked("trace")(...args).steps,
    shapes: (file, options) => ask({ ...options, command: "shapes", ...textOf(file) }),
    parts: (file, options) => ask({ ...options, command: "parts", ...textOf(file) }),
    experiment: (polygons, settings) => ask({ command: "experiment", polygons, settings }),
    version: ask({ command: "version" }).version,
  };
}
