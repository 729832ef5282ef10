// Calls into the program: text in and out, numbers in and out.

// Those that open a text.
const opening = ["page_load", "page_open_link", "page_open_sample", "page_open_lesson"];

export class Program {
  #module;
  #stopped = false;
  // Told when the program stops; and before a text is opened.
  onStop = () => {};
  onOpening = () => {};

  constructor(module) {
    this.#module = module;
  }

  // Calls a function whose arguments are texts and numbers; gives what it returns. Before that the program deals with the
  // clicks and keys that came before this moment: all take effect in the order in which they were made.
  call(name, ...args) {
    if (this.#stopped) throw new Error("The page stopped, and starts anew");
    if (opening.includes(name)) this.onOpening(args[0]);
    return this.#guarded((module) => {
      if (name !== "page_frame") module._page_catch_up?.();  // a frame deals with them itself
      const texts = [];
      const passed = args.map((arg) => {
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

  // What the browser tells of a press, before the event itself reaches the program.
  press(time, clicks) {
    if (!this.#stopped) this.#guarded((module) => module._page_press(time, clicks));
  }

  // Nothing that went through the program and was not caught there leaves it as it was.
  #guarded(act) {
    try {
      return act(this.#module);
    } catch (error) {
      this.stop(error);
      throw new Error("The page stopped, and starts anew", { cause: error });
    }
  }

  stop(error) {
    if (this.#stopped) return;
    this.#stopped = true;
    this.onStop(error);
  }
}
