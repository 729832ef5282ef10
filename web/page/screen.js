import { translated } from "../words/words.js";
import { begin, end } from "./work.js";

// Reports the canvas size in CSS and device pixels, the user's preferences, and a lost WebGL context.
export function connectScreen(program) {
  const canvas = document.getElementById("canvas");
  const measure = followSize(program, canvas);
  followPreferences(program);
  followContext(program, canvas);
  return { measure };
}

function followSize(program, canvas) {
  // The exact device pixels; at fractional ratios rounding only guesses. Emulated screens report CSS pixels, so a
  // number that differs by more than rounding is ignored.
  const measure = (exact) => {
    const { width, height } = canvas.getBoundingClientRect();
    if (!(width > 0 && height > 0)) return;
    const pixels = (css, told) => {
      const guess = css * devicePixelRatio;
      return told && Math.abs(told - guess) < 2 ? told : Math.round(guess);
    };
    program.call(
      "page_resize",
      width,
      height,
      devicePixelRatio,
      pixels(width, exact?.inlineSize),
      pixels(height, exact?.blockSize),
    );
  };
  const observer = new ResizeObserver(([entry]) => measure(entry.devicePixelContentBoxSize?.[0]));
  try {
    observer.observe(canvas, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(canvas);
  }
  measure();
  addEventListener("resize", () => measure());
  followRatio(() => measure());
  return measure;
}

// The present ratio's media query changes when the window moves to another screen.
function followRatio(changed) {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
    "change",
    () => {
      changed();
      followRatio(changed);
    },
    { once: true },
  );
}

// Whether the background is nearer to black than to white. In forced colours it is the system's.
function groundIsDark() {
  const [red, green, blue] = getComputedStyle(document.body)
    .backgroundColor.match(/[\d.]+/g)
    .map(Number);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue < 128;
}

function followPreferences(program) {
  const [dark, still, coarse, forced] = [
    "(prefers-color-scheme: dark)",
    "(prefers-reduced-motion: reduce)",
    "(pointer: coarse)",
    "(forced-colors: active)",
  ].map((query) => matchMedia(query));
  const tell = () => {
    const now = [forced.matches ? groundIsDark() : dark.matches, still.matches, coarse.matches];
    program.call("page_preferences", ...now.map(Number));
  };
  for (const query of [dark, still, coarse, forced]) query.addEventListener("change", tell);
  tell();
}

function followContext(program, canvas) {
  const cover = document.getElementById("cover");
  const progress = document.getElementById("progress");
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault(); // else the context is never restored
    begin();
    program.call("page_context", 1);
    progress.textContent = translated(
      "The connection to the graphics processor was lost. The drawing will return by itself; nothing is lost.",
    );
    cover.classList.add("see-through");
    cover.classList.remove("done");
  });
  canvas.addEventListener("webglcontextrestored", () => {
    program.call("page_context", 0);
    end();
    cover.classList.add("done");
  });
}
