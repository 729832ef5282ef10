// Lets the browser keep the page for use without a network, and reports a new version. Loaded after the first frame, so
// as not to delay it.
const betweenChecks = 3600000; // milliseconds; the browser also checks at each opening

// Calls `tell` once, when a new version is available or another tab has adopted it.
export async function keepForOffline(tell) {
  const container = navigator.serviceWorker;
  if (!container || navigator.connection?.saveData) return;
  let inControl = container.controller;
  let told = false;
  const newVersion = () => {
    if (!told) tell();
    told = true;
  };
  container.addEventListener("controllerchange", () => {
    if (inControl) newVersion();
    inControl = container.controller;
  });
  const registration = await container.register(new URL("service_worker.js", import.meta.url), {
    updateViaCache: "none",
  });
  // The first version, which is this page, needs no message.
  const look = () => registration.active && registration.waiting && newVersion();
  const follow = () => registration.installing?.addEventListener("statechange", look);
  registration.addEventListener("updatefound", follow);
  follow();
  look();
  checkNowAndThen(registration);
}

// For pages that stay open for days.
function checkNowAndThen(registration) {
  let checked = Date.now();
  document.addEventListener("visibilitychange", () => {
    if (document.hidden || Date.now() - checked < betweenChecks) return;
    checked = Date.now();
    registration.update().catch(() => {}); // without a network there is nothing new
  });
}
