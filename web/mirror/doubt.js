// The buttons that settle a number with two readings, below the field it was typed into.
import { say } from "../words/words.js";

let open; // { group, leave, field, text }

// Whether the buttons for this text are there already.
export const isAsked = (field, text) => open?.field === field && open.text === text;

export function forget() {
  open?.group.remove();
  open?.leave.abort();
  open = undefined;
}

// `choose` gets the reading that was pressed. Escape, another field, or a press elsewhere leaves the number unset.
export function askWhich(field, { whole, decimal }, choose) {
  forget();
  const group = document.createElement("div");
  group.className = "which";
  group.setAttribute("role", "group");
  group.setAttribute("aria-label", say("Which number is meant?"));
  for (const reading of [whole, decimal]) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "button";
    button.textContent = reading;
    button.addEventListener("pointerdown", (event) => event.preventDefault()); // the field keeps the focus
    button.addEventListener("click", () => {
      forget();
      choose(reading);
    });
    group.append(button);
  }
  group.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key !== "Escape") return;
    forget();
    field.focus();
  });
  const { left, bottom } = field.getBoundingClientRect();
  Object.assign(group.style, { left: `${left}px`, top: `${bottom + 4}px` });
  field.after(group);
  const leave = new AbortController();
  const toButtons = (event) => {
    if (event.key !== "Tab" || event.shiftKey) return;
    event.preventDefault();
    group.firstChild.focus();
  };
  field.addEventListener("keydown", toButtons, { signal: leave.signal });
  const elsewhere = ({ target }) => target === field || group.contains(target) || forget();
  document.addEventListener("pointerdown", elsewhere, { signal: leave.signal });
  document.addEventListener("focusin", (event) => event.target.matches("input") && elsewhere(event), {
    signal: leave.signal,
  });
  open = { group, leave, field, text: field.value };
}
