// Announces a new version of the page. Nothing is loaded before the button is pressed.
import { closingButton, openCard, whenNoCard } from "../kit/card.js";
import { el } from "../kit/elements.js";
import { translated } from "../words/words.js";
import { hasPhoto } from "../photo/photo.js";

export function newVersion(page) {
  whenNoCard(() => show(page));
}

async function show(page) {
  const sentence = el("p", { role: "status" });
  await openCard(page, {
    name: "new-version",
    title: "New version",
    body: [sentence, el("div", { class: "ways" }, closingButton("Load it", { class: "button primary" }, load))],
  });
  // Set afterwards, so that it is read out.
  sentence.textContent = translated(
    hasPhoto()
      ? "A new version of evenlift is ready. Your work stays open, except for the picture behind the drawing."
      : "A new version of evenlift is ready. Your work stays open.",
  );
}

// The new version's service worker waits for a message; if another tab has sent it, the page need only be loaded again.
async function load() {
  const registration = await navigator.serviceWorker.getRegistration();
  if (!registration?.waiting) return location.reload();
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
  registration.waiting.postMessage("take over");
}
