// An entry is { element, control }.
import { asRead } from "../words/numbers.js";
import { plainValue } from "./typed.js";

function button(entry, actions) {
  const element = document.createElement("button");
  element.type = "button";
  element.addEventListener("click", () => entry.control.enabled && actions.press(entry.control));
  return element;
}

function choice(entry, actions) {
  const element = document.createElement("select");
  element.addEventListener("change", () => actions.choose(entry.control, element.selectedIndex));
  return element;
}

function slider(entry, actions) {
  const element = document.createElement("input");
  element.type = "range";
  element.addEventListener("input", () => actions.move(entry.control, Number(element.value)));
  return element;
}

// Receives the pointer, so that a click or a tap begins to type.
function field(entry, actions) {
  const element = document.createElement("input");
  element.type = "text";
  element.inputMode = "decimal";
  element.autocomplete = "off";
  element.spellcheck = false;
  let before = "",
    previewed = false;
  const begin = () => {
    previewed = false;
    before = element.value = entry.control.exact ? asRead(entry.control.exact) : plainValue(entry.control.value);
    element.removeAttribute("aria-invalid");
    element.select();
  };
  // Returns whether the typed value is now in force.
  const commit = (confirmed = false) => {
    if (element.value === before && !(confirmed && !entry.control.setting)) return true;
    const done = actions.type(entry.control, element.value, confirmed);
    if (done) before = element.value;
    else if (previewed) actions.withdraw(entry.control); // a refused value is not shown
    element.setAttribute("aria-invalid", String(!done));
    if (!done && confirmed) element.select(); // the next text replaces it
    return done;
  };
  entry.begin = begin;
  entry.isTyped = () => element.value !== before;
  // Keyboard users continue from this field, others return to the drawing. After a number that is not a setting, the
  // next one follows; if nothing was typed, Enter confirms all.
  const confirm = () => {
    const { setting } = entry.control,
      untouched = !previewed && element.value === before;
    if (!setting && untouched) {
      actions.press(entry.control);
      actions.next(entry.control);
    } else if (commit(true)) {
      if (!setting) actions.next(entry.control);
      else if (document.documentElement.classList.contains("by-key")) actions.again(entry);
      else actions.leave();
    }
  };
  element.addEventListener("focus", begin);
  element.addEventListener("click", () => element.getAttribute("aria-invalid") === "true" && element.select());
  element.addEventListener("input", () => {
    if (entry.control.setting) return;
    previewed = true;
    actions.preview(entry.control, element.value);
  });
  element.addEventListener("blur", () => {
    commit();
    element.value = entry.control.value;
  });
  element.addEventListener("keydown", (event) => {
    const way = { ArrowUp: "+", ArrowDown: "-" }[event.key];
    if (event.key === "Enter") confirm();
    else if (event.key === "Escape") {
      element.value = before;
      element.removeAttribute("aria-invalid");
      if (previewed) actions.withdraw(entry.control);
      actions.leave();
    } else if (way && entry.control.setting && commit()) {
      event.preventDefault();
      actions.press({ ...entry.control, name: `${entry.control.name} ${way}` });
      entry.renew = begin;
    }
  });
  // Over the field the wheel still scrolls the panel. The canvas believes that the pointer has left.
  element.addEventListener(
    "wheel",
    (event) => {
      const canvas = document.getElementById("canvas");
      canvas.dispatchEvent(new MouseEvent("mousemove", event));
      canvas.dispatchEvent(new WheelEvent("wheel", event));
    },
    { passive: true },
  );
  return element;
}

// A number of the result, only to be read.
const text = () => document.createElement("p");

const makers = { button, toggle: button, choice, slider, number: field, text };

const isOfHistory = (event) =>
  (event.ctrlKey || event.metaKey) && !event.altKey && ["z", "y"].includes(event.key.toLowerCase());

// A browser takes the focus from disabled elements, so a focused one stays enabled.
function showEnabled({ element, control }) {
  const disabled = !control.enabled;
  element.disabled = disabled && element !== document.activeElement;
  if (disabled) setAttribute(element, "aria-disabled", "true");
  else element.removeAttribute("aria-disabled");
}

export function createElement(control, actions) {
  const entry = { control };
  entry.element = makers[control.kind](entry, actions);
  entry.element.addEventListener("focus", () => entry.control.seen || actions.reveal(entry.control));
  entry.element.addEventListener("blur", () => showEnabled(entry));
  entry.element.addEventListener("keydown", (event) => {
    if (isOfHistory(event) && !entry.isTyped?.()) {
      // the text being typed has an undo of its own
      event.preventDefault();
      event.stopPropagation();
      entry.renew = entry.begin;
      actions.key(event);
      return;
    }
    if (event.key !== "Escape") return;
    event.stopPropagation();
    if (control.kind !== "number") actions.escape(); // a field reverts only its own text
  });
  return entry;
}

function setAttribute(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

function showChoices(element, { choices, current }) {
  if (element.length !== choices.length || choices.some((text, i) => element.options[i].text !== text))
    element.replaceChildren(...choices.map((text) => new Option(text)));
  element.selectedIndex = Number(current);
}

export function showControl(entry, control) {
  const { element } = entry,
    changed = entry.control.value !== control.value;
  entry.control = control;
  for (const side of ["left", "top", "width", "height"]) element.style[side] = `${control.place[side]}px`;
  if (control.kind === "text") {
    const words = `${control.label}: ${control.value}`;
    if (element.textContent !== words) element.textContent = words;
    return;
  }
  setAttribute(element, "aria-label", control.label);
  showEnabled(entry);
  element.classList.toggle("unseen", !control.seen);
  if (control.kind === "toggle") setAttribute(element, "aria-pressed", String(control.on));
  if (control.kind === "choice") showChoices(element, control);
  if (control.kind === "slider") {
    Object.assign(element, { min: control.low, max: control.high, step: control.step });
    if (element.valueAsNumber !== control.at) element.value = control.at;
    if (control.value) setAttribute(element, "aria-valuetext", control.value);
  }
  if (control.kind !== "number") return;
  if (element !== document.activeElement) element.value = control.value;
  else if (entry.renew && changed) {
    entry.renew();
    entry.renew = undefined;
  }
}
