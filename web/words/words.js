// English words are written where they are said, and are the keys in the file of the reader's language (assets/words).
// Each bundle of the page has a copy of this module, so the window keeps the words for all.
const place = Symbol.for("evenlift words");

export function addTranslations(words) {
  globalThis[place] = words;
}

// [English, translated]; none if the page speaks English.
export const translations = () => Object.entries(globalThis[place] ?? {});

// The text itself if it was not translated.
export function translated(english) {
  const words = globalThis[place];
  return words && Object.hasOwn(words, english) ? words[english] : english;
}

class AsTyped {
  constructor(text) {
    this.text = text;
  }
}

// A value that a user typed, which say() does not translate.
export const asTyped = (text) => new AsTyped(text);

// The translated pattern, with each {name} replaced by its value: say("Robot {robot}", { robot: 3 }). Values that are
// texts are also translated, unless they are as typed.
export function say(english, values = {}) {
  return translated(english).replace(/\{(\w+)\}/g, (whole, name) => {
    if (!Object.hasOwn(values, name)) return whole;
    const value = values[name];
    return value instanceof AsTyped ? value.text : translated(String(value));
  });
}

// As after a colon: in English with a small letter.
export function lowered(sentence) {
  const said = translated(sentence);
  return document.documentElement.lang === "en" ? said.charAt(0).toLowerCase() + said.slice(1) : said;
}
