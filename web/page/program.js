// Loads and calls the program: texts, bytes and numbers in; texts, JSON and numbers out.

// These open a text.
const opening = ["page_load", "page_open_link", "page_open_sample", "page_apply_text", "page_open_lesson"];

// A file did not arrive, or the files are of different versions; the cause says more.
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

// After a new version was published, the browser may have kept some files of the old one. Makes it take all anew.
async function notLoaded(cause) {
  if (cause instanceof WebAssembly.CompileError) throw cause; // the browser cannot run it
  await Promise.allSettled(
    ["page.js", "evenlift.js", "evenlift.wasm", ...Object.values(fonts)].map((name) =>
      fetch(name, { cache: "reload" }),
    ),
  );
  throw new NotLoaded(cause);
}

// The page's typeface, by weight. The canvas and the HTML have it from the same bytes; characters that it lacks, such
// as letters of other languages, come from the system.
const fonts = { 400: "Inter-Regular.otf", 600: "Inter-SemiBold.otf" };

async function font([weight, name]) {
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  const bytes = await answer.arrayBuffer();
  document.fonts.add(new FontFace("Inter", bytes, { weight }));
  return new Uint8Array(bytes);
}

export async function loadProgram(options) {
  const files = Promise.all([
    import("./evenlift.js"),
    compile("evenlift.wasm"),
    Promise.all(Object.entries(fonts).map(font)),
  ]);
  const [{ default: createModule }, compiled, faces] = await files.catch(notLoaded);
  const module = await new Promise((done, fail) => {
    const instantiateWasm = (given, receive) => {
      const instance = WebAssembly.instantiate(compiled, given).catch(notLoaded);
      instance.then((ready) => receive(ready, compiled)).catch(fail);
      return {};
    };
    createModule({ ...options, instantiateWasm }).then(done, fail);
  });
  const program = new Program(module);
  program.call("page_fonts", ...faces);
  return program;
}

export class Program {
  #module;
  #stopped = false;
  // Called when the program stops, before a text is opened, and after each frame.
  onStop = () => {};
  onOpening = () => {};
  onPicture = () => {};

  constructor(module) {
    this.#module = module;
  }

  // Passes texts, numbers and bytes (as address and length). Before, the program handles all earlier clicks and keys,
  // so that everything takes effect in order.
  call(name, ...args) {
    if (this.#stopped) throw new Error("The page stopped and is starting again");
    if (opening.includes(name)) this.onOpening(args[0]);
    return this.#guarded((module) => {
      if (name !== "page_frame") module._page_catch_up?.(); // a frame handles them itself
      const texts = [];
      const passed = args.flatMap((arg) => {
        if (arg instanceof Uint8Array) {
          const at = module._malloc(arg.length || 1);
          if (!at) throw new Error("There is not enough memory");
          module.HEAPU8.set(arg, at);
          texts.push(at);
          return [at, arg.length];
        }
        if (typeof arg !== "string") return arg;
        const bytes = module.lengthBytesUTF8(arg) + 1;
        const at = module._malloc(bytes);
        if (!at) throw new Error("There is not enough memory");
        module.stringToUTF8(arg, at, bytes);
        texts.push(at);
        return at;
      });
      const answer = module[`_${name}`](...passed);
      for (const at of texts) module._free(at);
      return answer;
    });
  }

  number(name, ...args) {
    return this.call(name, ...args);
  }

  text(name, ...args) {
    return this.#module.UTF8ToString(this.call(name, ...args));
  }

  json(name, ...args) {
    const text = this.text(name, ...args);
    return text ? JSON.parse(text) : null;
  }

  // From now on the module says these words, [English, translated].
  speak(words) {
    for (const [english, translated] of words) this.call("words_translate", english, translated);
  }

  get stopped() {
    return this.#stopped;
  }

  // A press must reach the program before the event itself does.
  press(time, clicks) {
    if (!this.#stopped) this.#guarded((module) => module._page_press(time, clicks));
  }

  // After an uncaught exception, the program's memory cannot be trusted.
  #guarded(act) {
    try {
      return act(this.#module);
    } catch (error) {
      this.stop(error);
      throw new Error("The page stopped and is starting again", { cause: error });
    }
  }

  stop(error) {
    if (this.#stopped) return;
    this.#stopped = true;
    this.onStop(error);
  }
}
