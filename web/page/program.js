// Calls into the program: texts, bytes and numbers in; texts, JSON and numbers out.

// The functions that open a text.
const opening = ["page_load", "page_open_link", "page_open_sample", "page_open_lesson"];

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

  // Calls a function with texts, numbers and bytes (passed as an address and a length) and returns its result. Before
  // the call the program handles all earlier clicks and keys, so that everything takes effect in the order in which it
  // was done.
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

  // The bytes at the address that a function returns, as a copy.
  bytes(name, size) {
    const at = this.call(name);
    return this.#module.HEAPU8.slice(at, at + size);
  }

  // Returns null for an empty text.
  json(name, ...args) {
    const text = this.text(name, ...args);
    return text ? JSON.parse(text) : null;
  }

  // From now on the module says these words, [English, translated], in the reader's language.
  speak(words) {
    if (this.#module._words_translate)
      for (const [english, translated] of words) this.call("words_translate", english, translated);
  }

  get stopped() {
    return this.#stopped;
  }

  // Passes a press to the program before the event itself reaches it.
  press(time, clicks) {
    if (!this.#stopped) this.#guarded((module) => module._page_press(time, clicks));
  }

  // After an exception that the program did not catch, its memory cannot be trusted.
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
