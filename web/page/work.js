// Counts what evenlift.idle() waits for: frames that are due, answers that are awaited, and texts still to be written.
// Match every begin() with an end().
let open = 0;
let waiting = [];

// While idle() is awaited, throttled work runs at once.
let awaiting = 0;
const hurries = [];

export const isAwaited = () => awaiting > 0;

// Called when a wait for idle() begins.
export function whenAwaited(hurry) {
  hurries.push(hurry);
}

export function begin() {
  ++open;
}

export function end() {
  if (--open > 0) return;
  const told = waiting;
  waiting = [];
  for (const resolve of told) resolve();
}

// The windows have their own copy of this module, so they report their work by an event (under_way.js).
document.addEventListener("evenlift-work", ({ detail: promise }) => {
  begin();
  promise.then(end, end);
});

const nextTask = () => new Promise((done) => setTimeout(done));

// The browser reports changed sizes and preferences with its next frame. A hidden page gets no frames, but a task.
const nextPicture = () =>
  document.hidden ? nextTask() : new Promise((done) => requestAnimationFrame(done)).then(nextTask);

// Animations that end; a sign that something is loading runs for ever.
function motions() {
  const ending = document
    .getAnimations()
    .filter((motion) => motion.playState === "running" && Number.isFinite(motion.effect.getComputedTiming().endTime));
  return Promise.allSettled(ending.map(({ finished }) => finished));
}

export async function idle() {
  ++awaiting;
  for (const hurry of hurries) hurry();
  document.dispatchEvent(new Event("evenlift-hurry"));
  do {
    await nextPicture();
    while (open > 0) await new Promise((done) => waiting.push(done));
    await motions();
    await nextPicture();
  } while (open > 0);
  --awaiting;
}
