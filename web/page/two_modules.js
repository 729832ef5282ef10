// The page's program is two modules of WebAssembly (cmake/two_modules.mjs): evenlift.wasm has the functions that the
// first picture needs, evenlift_rest.wasm the others. The first has a placeholder for each of the others, which the
// second replaces. A program that was not divided is one module.

const rest = "evenlift_rest.wasm";

// The second module did not arrive, or is of another version; the cause says more.
export class NotLoaded extends Error {
  constructor(cause) {
    super("A part of the page did not arrive.", { cause });
  }
}

async function compile(name) {
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  // Some servers do not know this type.
  if (answer.headers.get("Content-Type") === "application/wasm") return WebAssembly.compileStreaming(answer);
  return WebAssembly.compile(await answer.arrayBuffer());
}

// Blocks the page, unlike compile().
function compileAtOnce(name) {
  const request = new XMLHttpRequest();
  request.open("GET", name, false);
  request.overrideMimeType("text/plain; charset=x-user-defined"); // each byte becomes a character and stays readable
  request.send();
  if (request.status !== 200) throw new Error(`${name}: ${request.status}`);
  return new WebAssembly.Module(Uint8Array.from(request.responseText, (character) => character.charCodeAt(0)));
}

// Returns Emscripten's module, and the function that loads the rest. A call that needs the rest earlier waits for it.
export async function createProgram(options) {
  const [{ default: createModule }, first] = await Promise.all([import("./evenlift.js"), compile("evenlift.wasm")]);
  const space = WebAssembly.Module.imports(first).find(({ module }) => module.startsWith("placeholder"))?.module;
  let exports;
  let whole = !space;

  const table = () => Object.values(exports).find((value) => value instanceof WebAssembly.Table);
  // Both names end alike, so that modules of different versions cannot be joined.
  const imports = () => ({ [space.replace("placeholder", "primary")]: exports });
  const joinAtOnce = () => {
    try {
      new WebAssembly.Instance(compileAtOnce(rest), imports());
    } catch (cause) {
      throw new NotLoaded(cause);
    }
    whole = true;
  };
  const placeholder = (index) => {
    return (...given) => {
      if (!whole) joinAtOnce();
      return table().get(index)(...given);
    };
  };
  const placeholders = space && { [space]: new Proxy({}, { get: (_, index) => placeholder(index) }) };

  const module = await new Promise((done, fail) => {
    const instantiateWasm = (given, receive) => {
      const received = (instance) => {
        ({ exports } = instance);
        receive(instance, first);
      };
      WebAssembly.instantiate(first, { ...given, ...placeholders })
        .then(received)
        .catch(fail);
      return {};
    };
    createModule({ ...options, instantiateWasm }).then(done, fail);
  });
  const loadRest = async () => {
    if (whole) return;
    try {
      await WebAssembly.instantiate(await compile(rest), imports());
    } catch (cause) {
      throw new NotLoaded(cause);
    }
    whole = true;
  };
  return { module, loadRest };
}
