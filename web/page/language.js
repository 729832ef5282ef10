// The reader's language: that of the address (`?lang=de`), the one chosen here, or the browser's.
import { addTranslations, translated } from "../words/words.js";
import { lasting, read, write } from "./storage.js";

const others = ["de"]; // each with a file words-….json (assets/words)
const kept = "evenlift.language";

function language() {
  const asked = new URLSearchParams(location.search).get("lang") || read(lasting, kept) || navigator.language;
  const name = asked.slice(0, 2).toLowerCase();
  return others.includes(name) ? name : "en";
}

// Puts the reader's language into the page's own texts. Without its file the page speaks English.
export async function speak() {
  const name = language();
  if (name === "en") return;
  const words = await fetch(`words-${name}.json`)
    .then((answer) => answer.json())
    .catch(() => undefined);
  if (!words) {
    document.documentElement.lang = "en"; // cover.js expected it
    return;
  }
  addTranslations(words);
  document.documentElement.lang = name;
  translateElements();
}

function translateElements() {
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const english = texts.currentNode.data.trim();
    if (english) texts.currentNode.data = translated(english);
  }
  for (const element of document.querySelectorAll("[aria-label]")) element.ariaLabel = translated(element.ariaLabel);
}

// Loads the page in the other language, and removes `lang` from the address.
export function changeLanguage() {
  write(lasting, kept, language() === "en" ? "de" : "en");
  const url = new URL(location.href);
  url.searchParams.delete("lang");
  if (url.href === location.href) location.reload();
  else location.replace(url);
}
