// The ready-made lessons in the page's language (assets/lessons).
import { fetchJson } from "../kit/fetched.js";

export function fetchLessons() {
  const { lang } = document.documentElement;
  return fetchJson(lang === "en" ? "lessons.json" : `lessons-${lang}.json`);
}
