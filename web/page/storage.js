// What the browser keeps. Storage may be full, or forbidden altogether; the page works without.

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

// Whether it is kept now. An empty text keeps nothing.
export function write(storage, key, text) {
  try {
    if (text) storage().setItem(key, text);
    else storage().removeItem(key);
    return true;
  } catch {
    return false;
  }
}
