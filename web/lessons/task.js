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
  const state = el("p", { class: "second", role: "status" });
  const answer = el("div", { class: "second" });
  const brief = el("p", { class: "brief", role: "status" });
  const copy = button("Copy result", { onclick: copyResult }, "copy");
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
        ...(begun.numbered ? [numberField()] : []),
        closingButton("Leave the task", { class: "button bare" }, leaveTask),
      ),
    ],
    closed: () => leave.abort(),
  });

  // A lesson stays open after its steps, and its last step opens the card again.
  function leaveTask() {
    if (!program.number("page_walkthrough_is_open")) program.call("page_close_task");
  }

  // The learner's number, which makes the task another one.
  function numberField() {
    const field = el("input", { inputmode: "numeric", size: "9", maxlength: "9", value: String(begun.number) });
    field.addEventListener("change", () => {
      const number = learnersNumber(field.value.trim());
      if (number === undefined) field.value = String(begun.number);
      else if (number !== begun.number) again(number);
    });
    return el("label", { class: "row second" }, "Your number", field);
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
    const { goals, changed, kept, may } = JSON.parse(text);
    list.replaceChildren(...goals.map(row), ...changed.map(changedRow));
    state.textContent = translated(kept ? "Done! Copy the result to hand it in." : may);
    const met = goals.filter((goal) => goal.kept).length;
    const [notAllowed] = changed;
    brief.textContent = kept
      ? state.textContent
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
