// Counts what is under way, so that evenlift.idle() can wait for it: frames that are due, answers that are awaited, and
// texts that are to be written. Whoever calls begin() also calls end().
let open = 0;
let waiting = [];

// While somebody awaits idle(), throttled work runs at once.
let awaiting = 0;
const hurries = [];

export const isAwaited = () => awaiting > 0;

// `hurry` is called when somebody begins to wait.
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

// The windows are a file of their own, and with it a copy of this module: they tell by an event (under_way.js).
document.addEventListener("evenlift-work", ({ detail: promise }) => {
  begin();
  promise.then(end, end);
});

const nextTask = () => new Promise((done) => setTimeout(done));

// The browser reports changed sizes and preferences with its next picture. A hidden page gets
// no pictures: there a task takes its place.
const nextPicture = () =>
  document.hidden ? nextTask() : new Promise((done) => requestAnimationFrame(done)).then(nextTask);

// Motions that end: what shows that something is loading goes on for ever.
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
