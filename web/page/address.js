// The query of the page's address: `?lesson=NAME` with a learner's `number=`, `challenge=1`, `place=4` with `beat=…`, and
// `embed=1`.
export function readAddress() {
  const asked = new URLSearchParams(location.search);
  return {
    embed: asked.get("embed") === "1",
    challenge: asked.get("challenge") === "1",
    lesson: asked.get("lesson") ?? "",
    number: learnersNumber(asked.get("number")) ?? 1,
    place: robotsToPlace(asked.get("place")),
    beat: scoreToBeat(asked.get("beat")),
  };
}

// The number of a learner, who gets a task of their own by it (core/include/evenlift/task.h); undefined for any other
// text.
export function learnersNumber(text) {
  return /^\d{1,9}$/.test(text ?? "") ? Number(text) : undefined;
}

// The number of robots that a challenge asks for, from 3 to 9, or 0.
function robotsToPlace(text) {
  return /^[3-9]$/.test(text ?? "") ? Number(text) : 0;
}

// The score of the sender of a challenge: [greatest load, spread, share covered, held]. Loads of 0 mean that the object
// falls. Nothing for anything else: the numbers come from outside.
function scoreToBeat(text) {
  const numbers = (text ?? "").split(",").map(Number);
  const [most, spread, covered, held] = numbers;
  const sound =
    numbers.length === 4 &&
    numbers.every((number) => Number.isFinite(number) && number >= 0 && number <= 1e9) &&
    spread <= most &&
    covered <= 1 &&
    (held === 0 || held === 1);
  return sound ? numbers : undefined;
}

// Puts the lesson, the learner's number and the challenge into an address, or removes them. The rest of its query stays.
export function withLesson(url, { lesson = "", number = 1, challenge = false }) {
  const rest = partsOf(url, /^(lesson|number|challenge)(=|$)/);
  if (lesson) rest.push(`lesson=${lesson}`); // its characters need no escape (lesson_source.js)
  if (number !== 1) rest.push(`number=${number}`);
  if (challenge) rest.push("challenge=1");
  url.search = rest.join("&");
  return url;
}

// Puts a challenge to place robots into an address, with a score to beat, or removes it.
export function withPlaces(url, { place = 0, beat } = {}) {
  const rest = partsOf(url, /^(place|beat)(=|$)/);
  if (place) rest.push(`place=${place}`);
  if (place && beat) rest.push(`beat=${beat.map((number) => Number(number.toPrecision(4))).join(",")}`);
  url.search = rest.join("&");
  return url;
}

function partsOf(url, removed) {
  return url.search
    .slice(1)
    .split("&")
    .filter((part) => part && !removed.test(part));
}
