// Calls into the program: text in and out, numbers in and out.
export class Program {
  #module;
  constructor(module) {
    this.#module = module;
  }

  // Calls a function whose arguments are texts and numbers; gives what it returns.
  call(name, ...args) {
    const module = this.#module;
    const texts = [];
    const passed = args.map((arg) => {
      if (typeof arg !== "string") return arg;
      const bytes = module.lengthBytesUTF8(arg) + 1;
      const at = module._malloc(bytes);
      module.stringToUTF8(arg, at, bytes);
      texts.push(at);
      return at;
    });
    try {
      return module[`_${name}`](...passed);
    } finally {
      for (const at of texts) module._free(at);
    }
  }

  number(name, ...args) {
    return this.call(name, ...args);
  }

  text(name, ...args) {
    return this.#module.UTF8ToString(this.call(name, ...args));
  }
}
