// Tells the page that something is under way until the promise is settled (work.js); gives the promise back.
export function underWay(promise) {
  document.dispatchEvent(new CustomEvent("evenlift-work", { detail: promise }));
  return promise;
}
