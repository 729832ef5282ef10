// The list of controls that the program lays out (wasm/ui/controls.h).

// Whether all of the control is in the visible part of its card.
export function isSeen({ place, window }) {
  return (
    place.left >= window.left &&
    place.top >= window.top &&
    place.left + place.width <= window.left + window.width &&
    place.top + place.height <= window.top + window.height
  );
}

// The plus and minus buttons of a stepper whose value can be typed: the field has keys for them.
function isEndOf(fields, { card, name }) {
  return / [-+]$/.test(name) && fields.has(`${card}/${name.slice(0, -2)}`);
}

// Gives each control a `key` of its own, though a card may have two controls of one name.
export function withKeys(all) {
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
