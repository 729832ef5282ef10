// Runs before the page is shown, and before anything else of it arrives. Says which cover belongs to this visit
// (page.css), asks for the program, and keeps what is pressed until the page is ready (page.js).
{
  const root = document.documentElement;
  const stored = (storage, key) => {
    try {
      return storage().getItem(key) ?? "";
    } catch {
      return ""; // storage may be forbidden
    }
  };
  const lasting = () => localStorage;
  const works = [lasting, () => sessionStorage].some((storage) => stored(storage, "evenlift.work"));
  const asked = new URLSearchParams(location.search);
  const language = asked.get("lang") || stored(lasting, "evenlift.language") || navigator.language;
  if (/^de/i.test(language)) root.lang = "de";
  const isPlain = /^(\?lang=\w*)?$/.test(location.search);
  // Something other than the opening sample comes.
  if (location.hash.length > 1 || works || !isPlain) root.classList.add("opens");
  else if (stored(lasting, "evenlift.welcomed")) root.classList.add("knows");

  // Only now: on a slow line they would delay what is seen first.
  const add = (name, properties) => document.head.append(Object.assign(document.createElement(name), properties));
  add("script", { type: "module", src: "page.js" });
  add("link", { rel: "modulepreload", href: "evenlift.js" });
  for (const href of ["Inter-Regular.otf", "Inter-SemiBold.otf", "evenlift.wasm"])
    add("link", { rel: "preload", as: "fetch", crossOrigin: "", href });

  const most = 20;
  const kept = [];
  const leave = new AbortController();
  const keep = (event) => {
    if (document.querySelector("#problem:not([hidden])")) return;
    const way = event.target.closest?.("#first button");
    if (event.type === "keydown") {
      if (way && ["Enter", " "].includes(event.key)) return; // its click follows
      if (event.altKey || ["Tab", "Shift", "Control", "Meta"].includes(event.key)) return;
      if ((event.ctrlKey || event.metaKey) && !/^[zy]$/i.test(event.key)) return; // the browser's own
      event.preventDefault();
    }
    if (kept.length < most) kept.push(event);
    document.querySelector("#first .pressed")?.classList.remove("pressed");
    way?.classList.add("pressed");
    document.getElementById("waits").hidden = false;
  };
  for (const type of ["keydown", "click"]) addEventListener(type, keep, { capture: true, signal: leave.signal });
  // Once: ends the keeping. Returns the events, in their order.
  window.pressedOnCover = () => {
    leave.abort();
    return kept.splice(0);
  };
}
