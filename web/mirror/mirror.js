// The controls as HTML over the canvas, each covering its drawn control, and invisible until it has the focus. So
// keyboards and screen readers reach every control, and numbers are typed in a native field.
import { createElement, showControl } from "./elements.js";
import { withKeys } from "./controls.js";
import { say, translated } from "../words/words.js";
import { askWhich, forget, isAsked } from "./doubt.js";
import { settingValue, typedDoubt, typedProblem, unitOf } from "./typed.js";

// The panels' cards (begin_card() in wasm/panels) in reading order, with names for screen readers.
const cards = new Map([
  ["toolbar", "Toolbar"],
  ["bar", "Toolbar"],
  ["tool bar", "Tool"],
  ["panel", "Panel"],
  ["rail", "Panel"],
  ["sheet", "Panel"],
  ["player", "Player"],
  ["why here", "Why here?"],
  ["tools", "View"],
  ["way back", "View"],
  ["notice", "Notice"],
]);

function createGroup(name) {
  const group = document.createElement("div");
  group.setAttribute("role", "group");
  group.setAttribute("aria-label", translated(name));
  group.hidden = true;
  return group;
}

const beginsDrawing = ["Draw", "Shape", "Hole"];

// The program's actions on a control (wasm/page/main.cpp).
const press = 0,
  choose = 1,
  move = 2,
  reveal = 3,
  enter = 4,
  withdraw = 5;

// `field.awaited` names a field that a key asked for and that may not be laid out yet, or is empty. `field.begun` is
// the text already typed for it.
export function createMirror(program, field, notice) {
  const canvas = document.getElementById("canvas");
  const root = document.createElement("div");
  root.id = "mirror";
  canvas.after(root);
  const groups = new Map([...cards].map(([card, name]) => [card, createGroup(name)]));
  root.append(...groups.values());
  const shown = new Map(); // by key; see withKeys()
  let last = "";

  const leave = () => canvas.focus({ preventScroll: true });

  // "" for a number without a unit.
  function unitOfField({ is_length, value }) {
    const unit = unitOf(value) || (is_length ? program.text("page_length_unit") : "");
    return unit === "none" ? "" : unit;
  }

  const actions = {
    leave,
    press({ card, name }) {
      program.call("page_ask_control", press, card, name, 0);
      if (beginsDrawing.includes(name)) leave(); // for the arrow keys
    },
    choose: ({ card, name }, index) => program.call("page_ask_control", choose, card, name, index),
    move: ({ card, name }, value) => program.call("page_ask_control", move, card, name, value),
    reveal: ({ card, name }) => program.call("page_ask_control", reveal, card, name, 0),
    withdraw: ({ card, name }) => program.call("page_ask_control", withdraw, card, name, 0),
    // Returns whether the value is in force now; if not, a notice gives the reason. A number that is not a setting goes
    // to the control itself; `confirmed` is whether Enter was pressed.
    type(control, typed, confirmed) {
      const { setting, card, name, is_length } = control,
        unit = unitOfField(control);
      const { element } = shown.get(control.key) ?? {};
      if (isAsked(element, typed)) return false;
      const wrong = typedProblem(typed, setting, unit, is_length);
      forget();
      if (wrong) {
        notice(`${wrong}.`, true);
        const doubt = typedDoubt(typed, setting);
        if (doubt)
          askWhich(element, doubt, (reading) => {
            element.value = reading;
            actions.type(control, reading, confirmed);
            element.blur(); // types it again, which changes nothing
            leave();
          });
        return false;
      }
      const value = settingValue(typed, setting, unit);
      if (!setting) {
        const number = Number(value);
        if (value === "" || !Number.isFinite(number)) {
          notice(say("“{value}” is not a number.", { value }), true);
          return false;
        }
        program.call("page_ask_control", confirmed ? enter : move, card, name, number);
        return true;
      }
      const problem = program.text("page_set", `${setting}=${value}`);
      if (problem) notice(`${problem}.`, true);
      return !problem;
    },
    // For a number that is not a setting, once the text can be a number.
    preview(control, typed) {
      const { card, name, is_length } = control,
        unit = unitOfField(control),
        value = settingValue(typed, "", unit);
      if (value === "" || typedProblem(typed, "", unit, is_length) || !Number.isFinite(Number(value))) return;
      if (!is_length || Number(value) > 0) program.call("page_ask_control", move, card, name, Number(value));
    },
    // After a confirmation, the card's first number that is not a setting is typed.
    next({ card }) {
      const first = [...shown.values()]
        .map(({ control }) => control)
        .find((c) => c.card === card && c.kind === "number" && !c.setting);
      if (first) field.awaited = first.name;
      field.show();
    },
    // Begins again with the value in force.
    again(entry) {
      field.show();
      entry.begin();
    },
    key: ({ key, shiftKey }) => program.number("page_key", key, 1, shiftKey ? 1 : 0),
    // If the page does not use Escape, the focus returns to the drawing.
    escape() {
      if (!program.number("page_key", "Escape", 0, 0)) leave();
    },
  };

  // Does not move elements that are in the right place, so that the focus stays.
  function arrange(controls) {
    const at = new Map();
    for (const { key, card } of controls) {
      const group = groups.get(card),
        element = shown.get(key).element;
      const before = at.get(card);
      const next = before ? before.nextSibling : group.firstChild;
      if (next !== element) group.insertBefore(element, next);
      at.set(card, element);
    }
  }

  function update(controls) {
    const keys = new Set(controls.map(({ key }) => key));
    for (const [key, { element }] of shown) {
      if (keys.has(key)) continue;
      if (element === document.activeElement) leave();
      element.remove();
      shown.delete(key);
    }
    for (const control of controls) {
      let entry = shown.get(control.key);
      if (!entry) shown.set(control.key, (entry = createElement(control, actions)));
      showControl(entry, control);
    }
    arrange(controls);
    for (const group of groups.values()) group.hidden = !group.firstChild;
  }

  function focusAwaited() {
    const { awaited } = field;
    const found =
      awaited && [...shown.values()].find(({ control }) => control.kind === "number" && control.name === awaited);
    if (!found) return;
    field.awaited = "";
    if (found.element === document.activeElement) found.begin();
    else found.element.focus({ preventScroll: true });
    if (!field.begun) return;
    found.element.value = field.begun;
    field.begun = "";
    found.element.dispatchEvent(new Event("input"));
  }

  // Call this after each frame.
  return function drawn() {
    const text = program.text("page_controls");
    if (text !== last) {
      last = text;
      update(withKeys(JSON.parse(text)));
    }
    focusAwaited();
  };
}
