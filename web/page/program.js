// Calls the program: texts, bytes and numbers in; texts, JSON and numbers out.

// These open a text.
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

  // A copy of the bytes at the returned address.
  bytes(name, size) {
    const at = this.call(name);
    return this.#module.HEAPU8.slice(at, at + size);
  }

  json(name, ...args) {
    const text = this.text(name, ...args);
    return text ? JSON.parse(text) : null;
  }

  // From now on the module says these words, [English, translated].
  speak(words) {
    if (this.#module._words_translate)
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
