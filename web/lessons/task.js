// A lesson's task: its goals, with ticks that follow every change.
import { closingButton, openCard } from "../kit/card.js";
import { button, el, icon, paragraphs } from "../kit/elements.js";
import { asTyped, say, translated } from "../words/words.js";
import { learnersNumber } from "../page/address.js";

// `again(number)` opens another learner's task; `done` is called when the task is done for the first time.
export async function show(page, { again, done }) {
  const { program } = page;
  const begun = program.json("page_task");
  const list = el("ul", { class: "goals" });
  const state = el("p", { class: "state", role: "status" });
  const answer = el("div", { class: "second" });
  const brief = el("p", { class: "brief", role: "status" });
  const copy = button("Copy result", { onclick: copyResult }, "copy");
  const restart = button(
    "Start over",
    { title: "The robots stand as at the beginning again", onclick: () => again(begun.number) },
    "again",
  );
  restart.classList.add("restart");
  const number = begun.numbered ? numberRow() : undefined;
  const leave = new AbortController();
  let shown = "";
  let celebrated = false;
  const card = await openCard(page, {
    name: "task",
    title: begun.title,
    folds: true,
    body: [
      brief,
      el(
        "div",
        { class: "said" },
        el(
          "h2",
          {},
          translated(begun.title)
            .replace(new RegExp(`^${translated("Task: ")}`), "")
            .replace(/^./, (letter) => letter.toUpperCase()),
        ),
        ...(number ? [number.root] : []),
        ...paragraphs(begun.words),
        list,
        state,
        answer,
      ),
      el(
        "div",
        { class: "ways unfolded" },
        copy,
        ...question(),
        restart,
        closingButton("Leave the task", { class: "button bare" }, leaveTask),
      ),
    ],
    closed: () => leave.abort(),
  });

  // A lesson stays open after its steps, and its last step opens the card again.
  function leaveTask() {
    if (!program.number("page_walkthrough_is_open")) program.call("page_close_task");
  }

  // The learner's number, which makes the task another one: what was done is left only after a question.
  function numberRow() {
    const field = el("input", { inputmode: "numeric", size: "9", maxlength: "9", value: String(begun.number) });
    const root = el("div", { class: "number" });
    const asked = el("p", { class: "second", role: "status" });
    const keep = () => {
      field.value = String(begun.number);
      sure.remove();
      card.seat();
    };
    let wanted;
    const change = button("", { class: "button primary", onclick: () => again(wanted) });
    const sure = el("div", {}, asked, el("div", { class: "row" }, change, button("", { onclick: keep })));
    field.addEventListener("change", () => {
      wanted = learnersNumber(field.value.trim());
      if (wanted === undefined || wanted === begun.number) return keep();
      if (!JSON.parse(shown).begun) return again(wanted);
      asked.textContent = say("Number {number} has another object. What you did here is left behind.", {
        number: wanted,
      });
      change.textContent = say("Begin number {number}", { number: wanted });
      sure.querySelector(".row").lastChild.textContent = say("Stay with number {number}", { number: begun.number });
      root.append(sure);
      card.seat();
    });
    root.append(el("label", { class: "row second" }, "Your number", field));
    return { root };
  }

  function question() {
    const asked = program.text("page_lesson_question");
    if (!asked) return [];
    const ask = button("Question", {
      onclick: () => {
        const first = answer.children.length === 0;
        answer.replaceChildren(
          ...paragraphs(asked, { class: "question" }),
          ...(first ? [] : paragraphs(program.text("page_lesson_answer"))),
        );
        ask.textContent = translated("Answer");
        if (!first) ask.remove();
        card.seat();
      },
    });
    ask.classList.add("asks");
    return [ask];
  }

  async function copyResult() {
    const { kept } = program.json("page_task");
    const copied = await page.copy(page.address(program.text("page_link")));
    page.notice(
      !copied
        ? "The browser did not allow copying. The address bar holds the same link."
        : kept
          ? "The link to your result is copied."
          : "The link to your result is copied. The task is not done yet.",
      !copied,
    );
  }

  function refresh() {
    const text = program.text("page_task");
    if (text === shown) return;
    shown = text;
    if (!text) return card.close(); // undone, or another document was opened
    const { goals, changed, kept, may, begun: hasBegun } = JSON.parse(text);
    list.replaceChildren(...goals.map(row), ...changed.map(changedRow));
    if (kept) state.replaceChildren(el("b", {}, icon("check"), "Done!"), " ", say("Copy the result to hand it in."));
    else state.textContent = translated(may);
    restart.disabled = !hasBegun;
    const met = goals.filter((goal) => goal.kept).length;
    const [notAllowed] = changed;
    brief.textContent = kept
      ? `${translated("Done!")} ${translated("Copy the result to hand it in.")}`
      : notAllowed
        ? say("You changed {what}, which this task does not allow. Undo brings it back.", { what: notAllowed })
        : say("{title}: {met} of {goals}", { title: asTyped(begun.title), met, goals: goals.length });
    card.root.classList.toggle("done", kept);
    copy.classList.toggle("primary", kept);
    if (kept && !celebrated) {
      celebrated = true;
      card.root.classList.add("celebrates");
      done();
    }
    card.seat();
  }
  page.pictures.addEventListener("drawn", refresh, { signal: leave.signal });
  refresh();
  return card;
}

const tick = (kept) =>
  el(
    "span",
    { class: kept ? "tick kept" : "tick", role: "img", "aria-label": kept ? "kept" : "not kept" },
    icon(kept ? "check" : "close"),
  );

const row = ({ words, value, kept }) =>
  el("li", {}, tick(kept), el("span", {}, words), el("span", { class: "value" }, value || "–"));

const changedRow = (what) =>
  el(
    "li",
    {},
    tick(false),
    el("span", {}, say("You changed {what}, which this task does not allow. Undo brings it back.", { what })),
  );
