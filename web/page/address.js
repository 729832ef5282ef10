// The fragment is the link of a document, the link of a lesson (`L1.…`), or both with an `&` between them; programs
// that know only documents ignore what follows. The query is `?lesson=NAME` with a learner's `number=`, `challenge=1`,
// `place=4` with `beat=…`, and `embed=1`.
export function readAddress() {
  const asked = new URLSearchParams(location.search);
  return {
    embed: asked.get("embed") === "1",
    challenge: asked.get("challenge") === "1",
    lesson: lessonLinkIn(location.hash) || (asked.get("lesson") ?? ""),
    number: learnersNumber(asked.get("number")) ?? 1,
    place: robotsToPlace(asked.get("place")),
    beat: scoreToBeat(asked.get("beat")),
  };
}

export function linkIn(fragment) {
  const [first] = fragment.replace(/^#/, "").split("&");
  return isLessonLink(first) ? "" : first;
}
export function lessonLinkIn(text) {
  return /(?:^|[#&])(L\d+\.[^\s&]*)/.exec(text.trim())?.[1] ?? "";
}

// Only for a text that is nothing but an address or a link with a lesson: drawings and comments may contain the same
// characters.
export function linkedLesson(text) {
  const [alone] = /^[^\s<]\S*$/.exec(text.trim().replace(/^<|>\.?$/g, "")) ?? [""];
  const lesson = lessonLinkIn(alone);
  if (!lesson) return undefined;
  const number = learnersNumber(/[?&]number=(\d+)/.exec(alone)?.[1]);
  return { lesson, link: linkIn(alone.slice(alone.indexOf("#") + 1)), number };
}

export const isLessonLink = (text) => /^L\d+\./.test(text);

// Each number gives a learner another task (core/include/evenlift/task.h). Undefined for any other text.
export function learnersNumber(text) {
  return /^\d{1,9}$/.test(text ?? "") ? Number(text) : undefined;
}

// From 3 to 9; 0 for any other text.
function robotsToPlace(text) {
  return /^[3-9]$/.test(text ?? "") ? Number(text) : 0;
}

// [greatest load, spread, share covered, held] of the sender of a challenge; loads of 0 if the object falls. They come
// from outside, so other numbers are refused.
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

// Replaces or removes these parts of an address; the rest stays. A lesson that is a link goes into the fragment, which
// browsers do not send to the server.
export function withLesson(url, { lesson = "", number = 1, challenge = false }) {
  const rest = partsOf(url, /^(lesson|number|challenge)(=|$)/);
  const linked = isLessonLink(lesson) ? lesson : "";
  if (lesson && !linked) rest.push(`lesson=${lesson}`); // needs no escape (lesson_source.js)
  if (number !== 1) rest.push(`number=${number}`);
  if (challenge) rest.push("challenge=1");
  url.search = rest.join("&");
  url.hash = [linkIn(url.hash), linked].filter(Boolean).join("&");
  return url;
}

// Replaces or removes a challenge to place robots.
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
