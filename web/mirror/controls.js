// The controls that the program lays out (wasm/ui/controls.h).

// Whether all of the control is visible in its card.
export function isSeen({ place, window }) {
  return (
    place.left >= window.left &&
    place.top >= window.top &&
    place.left + place.width <= window.left + window.width &&
    place.top + place.height <= window.top + window.height
  );
}

// A stepper's plus and minus buttons: a field for its value has keys for them.
function isEndOf(fields, { card, name }) {
  return / [-+]$/.test(name) && fields.has(`${card}/${name.slice(0, -2)}`);
}

// Gives each control its own `key`, as a card may have two controls of one name.
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
