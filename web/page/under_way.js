// Counts as work until the promise is settled (work.js). Returns the promise.
export function underWay(promise) {
  document.dispatchEvent(new CustomEvent("evenlift-work", { detail: promise }));
  return promise;
}
