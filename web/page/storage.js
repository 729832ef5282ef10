// The browser's storage may be full or forbidden; the page works without it.

// Keys that two files use.
export const workKey = "evenlift.work";
export const historyKey = "evenlift.history";

// Where storage is forbidden, naming it throws.
export const lasting = () => localStorage;
export const ofThisTab = () => sessionStorage;

export function read(storage, key) {
  try {
    return storage().getItem(key) ?? "";
  } catch {
    return "";
  }
}

// Removes an empty text. Returns whether it worked.
export function write(storage, key, text) {
  try {
    if (text) storage().setItem(key, text);
    else storage().removeItem(key);
    return true;
  } catch {
    return false;
  }
}
