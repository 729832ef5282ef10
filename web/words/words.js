// The reader's language. English words are written where they are said, and are the keys by which they are found in the
// file of the reader's language (assets/words). The page's bundles each have a copy of this module, so the window keeps
// the words for all.
const place = Symbol.for("evenlift words");

export function addTranslations(words) {
  globalThis[place] = words;
}

// All words, as [English, translated]; none if the page speaks English.
export const translations = () => Object.entries(globalThis[place] ?? {});

// The text in the reader's language, and the text itself if it was not translated.
export function translated(english) {
  const words = globalThis[place];
  return words && Object.hasOwn(words, english) ? words[english] : english;
}

// The pattern in the reader's language, with each {name} replaced by its value: say("Robot {robot}", { robot: 3 }).
// Values that are texts are translated as well.
export function say(english, values = {}) {
  return translated(english).replace(/\{(\w+)\}/g, (whole, name) =>
    Object.hasOwn(values, name) ? translated(String(values[name])) : whole,
  );
}

// The sentence as it follows a colon: in English with a small letter.
export function lowered(sentence) {
  const said = translated(sentence);
  return document.documentElement.lang === "en" ? said.charAt(0).toLowerCase() + said.slice(1) : said;
}
