// The page's program is two modules of WebAssembly (cmake/two_modules.mjs): evenlift.wasm has the functions that the
// first picture needs, evenlift_rest.wasm the others. The first has a placeholder for each of the others, which the
// second replaces. A program that was not divided is one module.

const [first, rest] = ["evenlift.wasm", "evenlift_rest.wasm"];

// A file did not arrive, or the modules are of different versions; the cause says more.
export class NotLoaded extends Error {
  constructor(cause) {
    super("A part of the page did not arrive.", { cause });
  }
}

const notLoaded = (cause) => {
  throw new NotLoaded(cause);
};

async function compile(name) {
  const answer = await fetch(name).catch(notLoaded);
  if (!answer.ok) notLoaded(new Error(`${name}: ${answer.status}`));
  // Some servers do not know this type.
  if (answer.headers.get("Content-Type") === "application/wasm") return WebAssembly.compileStreaming(answer);
  return WebAssembly.compile(await answer.arrayBuffer());
}

// After a new version was published, the browser may have kept some files of the old one. Makes it take all anew.
const fetchAnew = () =>
  Promise.allSettled(["page.js", "evenlift.js", first, rest].map((name) => fetch(name, { cache: "reload" })));

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
  const [{ default: createModule }, compiled] = await Promise.all([
    import("./evenlift.js").catch(notLoaded),
    compile(first),
  ]);
  const space = WebAssembly.Module.imports(compiled).find(({ module }) => module.startsWith("placeholder"))?.module;
  let exports;
  let whole = !space;

  const table = () => Object.values(exports).find((value) => value instanceof WebAssembly.Table);
  // The names have the version, so that modules of different versions cannot be joined.
  const imports = () => ({ [space.replace(/^placeholder(-[0-9a-f]+).*/, "primary$1")]: exports });
  const joinAtOnce = () => {
    try {
      new WebAssembly.Instance(compileAtOnce(rest), imports());
    } catch (cause) {
      fetchAnew();
      notLoaded(cause);
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
        receive(instance, compiled);
      };
      WebAssembly.instantiate(compiled, { ...given, ...placeholders })
        .then(received)
        .catch(fail);
      return {};
    };
    createModule({ ...options, instantiateWasm }).then(done, fail);
  });
  const joinLater = async () => {
    if (whole) return;
    const second = await compile(rest).catch((cause) => whole || notLoaded(cause));
    if (whole) return;
    try {
      await WebAssembly.instantiate(second, imports());
    } catch (cause) {
      await fetchAnew();
      notLoaded(cause);
    }
    whole = true;
  };
  let loading;
  return { module, loadRest: () => (loading ??= joinLater()) };
}
