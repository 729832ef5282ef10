// What the package offers, made of its compiled WebAssembly: requests as JSON in, answers as JSON out.

// Why a request was refused. `message` is a sentence with its place; `code` and `place` say the same as data.
export class EvenliftError extends Error {
  name = "EvenliftError";

  constructor({ code, message, place }) {
    super(message);
    this.code = code;
    this.place = place;
  }
}

// What the module asks of its host: to hear that its memory grew, and to end. It has no files and no clock.
function hostOf(compiled) {
  const host = {};
  for (const { module, name } of WebAssembly.Module.imports(compiled)) {
    (host[module] ??= {})[name] = name === "emscripten_notify_memory_growth" ? () => {} : () => {
      throw new WebAssembly.RuntimeError(`evenlift cannot go on: ${name}`);
    };
  }
  return host;
}

function start(compiled) {
  const { exports } = new WebAssembly.Instance(compiled, hostOf(compiled));
  exports._initialize?.();
  return exports;
}

// The text that ends with a zero byte.
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

// These say what is asked for; all others are settings.
const members = ["centre_of_mass", "candidates", "failures", "format", "frame", "origin"];

// A seed beyond 2⁵³ is a BigInt, which JSON does not have; the core reads its digits.
const written = (value) => (typeof value === "bigint" ? String(value) : Array.isArray(value) ? value.join(",") : value);

function requestOf(command, polygon, options = {}) {
  const request = { command, [typeof polygon === "string" ? "text" : "polygon"]: polygon, settings: {} };
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined) continue;
    if (members.includes(name)) request[name] = value;
    else request.settings[name] = written(value);
  }
  return request;
}

export function createApi(compiled) {
  let running = start(compiled);

  // The answer as text, with the bytes that the program prints. A module that stopped is not used again.
  function run(request) {
    try {
      return answerOf(running, typeof request === "string" ? request : JSON.stringify(request));
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

  const asked = (command) => (polygon, options) => ask(requestOf(command, polygon, options));
  return {
    run,
    place: asked("place"),
    candidates: (...given) => asked("candidates")(...given).candidates,
    svg: (...given) => asked("svg")(...given).svg,
    poses: (...given) => asked("poses")(...given).poses,
    link: (...given) => asked("link")(...given).link,
    experiment: (polygons, settings = {}) => ask({ command: "experiment", polygons, settings }),
    version: ask({ command: "version" }).version,
  };
}
