// Access to the browser's storage. It may be full or forbidden; the page works without it.

// Keys that two files of the page read and write.
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

// Keeps a text, or removes it if it is empty. Returns whether that worked.
export function write(storage, key, text) {
  try {
    if (text) storage().setItem(key, text);
    else storage().removeItem(key);
    return true;
  } catch {
    return false;
  }
}
