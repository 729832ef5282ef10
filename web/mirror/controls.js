// Reads the list of controls that the program writes (wasm/ui/controls.cpp).
const names = [
  "kind",
  "card",
  "name",
  "label",
  "value",
  "setting",
  "enabled",
  "on",
  "left",
  "top",
  "width",
  "height",
  "windowLeft",
  "windowTop",
  "windowWidth",
  "windowHeight",
  "low",
  "high",
  "step",
  "at",
  "current",
  "exact",
];
const texts = new Set(["kind", "card", "name", "label", "value", "exact", "setting", "current"]);

// All of them, as they are listed.
export const listedControls = (text) => text.split("\n").filter(Boolean).map(readControl);

function readControl(line) {
  const fields = line.split("\t");
  const control = Object.fromEntries(names.map((name, i) => [name, texts.has(name) ? fields[i] : Number(fields[i])]));
  control.choices = fields.slice(names.length);
  return control;
}

// Whether all of the control is in the part of its card that is seen.
function isSeen(c) {
  return (
    c.left >= c.windowLeft &&
    c.top >= c.windowTop &&
    c.left + c.width <= c.windowLeft + c.windowWidth &&
    c.top + c.height <= c.windowTop + c.windowHeight
  );
}

// The ends of a stepper whose value can be typed: the field has keys for them.
function isEndOf(fields, { card, name }) {
  return / [-+]$/.test(name) && fields.has(`${card}/${name.slice(0, -2)}`);
}

// Each with a `key` of its own, though a card may have two of one name.
export function readControls(text) {
  const all = listedControls(text);
  const fields = new Set(all.filter(({ kind }) => kind === "number").map(({ card, name }) => `${card}/${name}`));
  const seen = new Map();
  return all
    .filter((control) => !isEndOf(fields, control))
    .map((control) => {
      const name = `${control.kind}/${control.card}/${control.name}`,
        count = seen.get(name) ?? 0;
      seen.set(name, count + 1);
      return { ...control, key: `${name}/${count}`, seen: isSeen(control) };
    });
}
