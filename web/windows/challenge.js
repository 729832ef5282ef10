// Somebody places robots on an object, and only then sees evenlift's. The card stays over the canvas, where the robots
// are dragged; the loads and the score follow.
import { openCard } from "../kit/card.js";
import { button, el } from "../kit/elements.js";
import { number } from "../words/numbers.js";
import { say, translated } from "../words/words.js";

const asks = { 3: "three", 4: "four", 5: "five", 6: "six", 7: "seven", 8: "eight", 9: "nine" };
const heads = ["", "Robots", "At most", "Spread", "Covered", "Held"];

// `beat` is the sender's score, if any (page/address.js).
export async function show(page, { place, beat }) {
  const { program } = page;
  const asked = say("Where would you put {number} robots?", { number: asks[place] });
  const question = el("h2", {});
  const advice = el("p", { class: "second", role: "status" });
  const copied = el("p", { class: "second", role: "status" }); // until the copied score changes
  const body = el("tbody");
  const table = el(
    "table",
    { class: "scores" },
    el("thead", {}, el("tr", {}, ...heads.map((head) => el("th", { scope: "col" }, head)))),
    body,
  );
  const reveal = button("Show evenlift's", { class: "button primary", onclick: () => act("page_show_answer") });
  const again = button("Try again", { onclick: () => act("page_try_again", place) });
  const copy = button("Copy challenge with my score", { onclick: () => copyChallenge() }, "copy");
  const leave = new AbortController();
  const card = await openCard(page, {
    name: "challenge",
    title: asked,
    body: [
      el("div", { class: "said" }, question, advice, table, copied),
      el("div", { class: "ways" }, reveal, again, copy),
    ],
    closed: () => {
      leave.abort();
      program.call("page_set_challenge", 0);
      page.leavePlaces();
    },
  });

  function act(...call) {
    program.call(...call);
    refresh();
  }

  async function copyChallenge() {
    const [mine] = program.json("page_scores");
    const address = page.placesAddress(program.text("page_challenge_link"), { place, beat: mine.numbers });
    const done = await page.copy(address);
    copied.textContent = translated(
      done
        ? "The challenge is copied: the object alone and your score, but not where your robots stand."
        : "The browser did not allow copying. The address bar holds a link to the same object.",
    );
    card.seat();
  }

  let shown = "";
  let scored = ""; // mine
  function refresh() {
    const scores = program.text("page_scores");
    if (scores === shown) return;
    shown = scores;
    const [mine, evenlifts] = JSON.parse(scores);
    if (scored !== mine.numbers.join()) copied.textContent = "";
    scored = mine.numbers.join();
    const revealed = evenlifts !== undefined;
    const rows = [["You", mine]];
    if (beat) rows.push(["To beat", toBeat(program, place, beat, mine)]);
    if (revealed) rows.push(["evenlift", evenlifts]);
    const best = bests(rows.map(([, score]) => asShown(score.numbers, mine)));
    body.replaceChildren(...rows.map(([who, score], i) => row(who, score, best[i])));
    question.textContent = revealed || beat ? translated("Can you beat this?") : asked;
    advice.textContent = translated(
      revealed
        ? "evenlift's answer uses the same number of robots. Drag yours to do better, or try again."
        : "Drag the robots so that all carry nearly the same, and so that the object does not tip.",
    );
    reveal.hidden = revealed;
    again.hidden = !revealed;
    copy.hidden = !revealed && !beat;
    card.seat();
  }
  page.pictures.addEventListener("drawn", refresh, { signal: leave.signal });
  refresh();
}

function row(who, score, best) {
  const falls = !score.most;
  const held = score.numbers[3] ? "yes" : "no";
  const cells = [score.robots, falls ? "it falls" : score.most, falls ? "–" : score.spread, score.covered, held];
  return el(
    "tr",
    {},
    el("th", { scope: "row" }, who),
    ...cells.map((text, i) => el("td", best[i - 1] ? { class: "best" } : {}, text)),
  );
}

// What looks like a tie is one.
const asShown = ([most, spread, covered, held], mine) => [
  Number(shownLike(most, mine.most)),
  Number(shownLike(spread, mine.spread)),
  Math.round(covered * 100),
  held,
];

// Whether each of a score's four numbers betters another score's and is bettered by none: a smaller load and spread,
// more covered, held.
function bests(scores) {
  const fallen = ([most]) => most === 0;
  const better = [
    (a, b) => (fallen(b) && !fallen(a)) || (!fallen(a) && a[0] < b[0]),
    (a, b) => (fallen(b) && !fallen(a)) || (!fallen(a) && a[1] < b[1]),
    (a, b) => a[2] > b[2],
    (a, b) => a[3] > b[3],
  ];
  return scores.map((own) =>
    better.map((beats) => scores.some((other) => beats(own, other)) && !scores.some((other) => beats(other, own))),
  );
}

// A number as another text shows its number, with as many decimals; without such a text, with three digits.
const shownLike = (value, text) =>
  text ? value.toFixed(/[.,](\d+)/.exec(text)?.[1].length ?? 0) : value.toPrecision(3);

// The sender's score comes from an address, so it is only claimed.
function toBeat(program, place, [most, spread, covered, held], mine) {
  const unit = program.text("page_weight_unit");
  const weight = (value, like) => `${number(Number(shownLike(value, like)))} ${unit}`;
  return {
    robots: String(place),
    most: most > 0 ? weight(most, mine.most) : "",
    spread: weight(spread, mine.spread),
    covered: `${Math.round(covered * 100)} %`,
    numbers: [most, spread, covered, held],
  };
}
