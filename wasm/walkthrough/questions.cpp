#include "walkthrough/walkthrough.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/screen.h"

namespace evenlift::view {

std::string place_in_words(const AppState& state) {
  const Timeline now = timeline(state);
  return say("{step} of {steps}", {now.at + 1, now.count});
}

namespace {

struct LeftOut {
  StepKind after;
  const char *one, *more;
};
// clang-format off
constexpr LeftOut left_out[] = {
    {StepKind::team,
     "{number} more team is chosen like this before the last: “All steps” shows them.",
     "{number} more teams are chosen like this before the last: “All steps” shows them."},
    {StepKind::exchange,
     "{number} smaller swap is left out here: “All steps” shows them.",
     "{number} smaller swaps are left out here: “All steps” shows them."},
    {StepKind::start,
     "{number} smaller set is made on the way: “All steps” shows them.",
     "{number} smaller sets are made on the way: “All steps” shows them."},
    {StepKind::cargo,
     "{number} more item of cargo is left out here: “All steps” shows them.",
     "{number} more items of cargo are left out here: “All steps” shows them."},
    {StepKind::ray,
     "There is {number} more ray like it: “All steps” shows it.",
     "There are {number} more rays like it: “All steps” shows them."},
    // After any other step:
    {StepKind::outcome,
     "There is {number} more pair like it: “All steps” shows it.",
     "There are {number} more pairs like it: “All steps” shows them."},
};
// clang-format on

}  // namespace

std::string left_out_in_words(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.trace || walk.script || walk.all_steps || walk.ask) return {};
  const Step& step = walk.detail.step;
  const std::uint32_t more = further_like(*walk.trace, step);
  if (more == 0) return {};
  const auto* row = std::find_if(std::begin(left_out), std::prev(std::end(left_out)),
                                 [&](const LeftOut& each) { return each.after == step.kind; });
  return say(more == 1 ? row->one : row->more, {more});
}

std::string walkthrough_in_words(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.trace) return {};
  std::string text =
      say("Step {place}, {chapter}.", {place_in_words(state), title(walk.detail.step.chapter)}) +
      " ";
  if (!walk.verdict.empty()) text += walk.verdict + " ";
  if (const std::string words = words_of_stop(state); !words.empty()) text += words + " ";
  text += walk.caption;
  if (!walk.formula.empty()) text += " " + walk.formula + ".";
  if (const std::string more = left_out_in_words(state); !more.empty()) text += " " + more;
  if (walk.ask) text += " " + walk.ask->text;
  return text;
}

namespace {

constexpr std::size_t most_offered = 6;  // per question

// Only one choice, or two ends that show the same load ratio or look like one point.
bool is_trivial(const Trace& trace, const Ask& asked) {
  if (asked.question.kind != QuestionKind::nearer_end) return asked.choices.size() < 2;
  constexpr double apart = 1.0 / 80;  // of the object's size
  const PairDetail& pair = *asked.detail.pair;
  const double longer = std::max(length(pair.a[1] - pair.a[0]), length(pair.b[1] - pair.b[0]));
  return longer < apart * trace.polygon().diagonal() ||
         ratio_in_words(pair.ends[0].ratio) == ratio_in_words(pair.ends[1].ratio);
}

// The answer and other choices, as far apart in their order as possible, since neighbours among
// very many look the same in the drawing.
std::vector<std::uint32_t> some_of(const std::vector<std::uint32_t>& choices,
                                   std::uint32_t answer) {
  const std::size_t n = choices.size();
  if (n <= most_offered) return choices;
  const auto at =
      static_cast<std::size_t>(std::find(choices.begin(), choices.end(), answer) - choices.begin());
  std::vector<std::uint32_t> some;
  for (std::size_t i = 0; i < most_offered; ++i)
    some.push_back(choices[(at + i * n / most_offered) % n]);
  std::sort(some.begin(), some.end());
  return some;
}

bool may_ask(Walkthrough& walk, const Ask& asked) {
  std::vector<std::uint32_t>& steps =
      walk.guesses.asked[static_cast<std::size_t>(asked.question.kind)];
  const auto has = [&](const std::vector<std::uint32_t>& some) {
    return std::find(some.begin(), some.end(), asked.step) != some.end();
  };
  if (has(steps)) return true;
  if (steps.size() < most_questions) {
    steps.push_back(asked.step);
    return true;
  }
  if (!has(walk.guesses.told)) walk.guesses.told.push_back(asked.step);
  return false;
}

// Any choice but the answer: the first one offered must not give it away.
std::size_t first_offered(const Ask& asked) {
  const std::size_t n = asked.choices.size();
  const auto answer = static_cast<std::size_t>(
      std::find(asked.choices.begin(), asked.choices.end(), asked.question.answer) -
      asked.choices.begin());
  return n < 2 ? 0 : (answer + 1 + asked.step % (n - 1)) % n;
}

std::optional<Ask> question_of(const Trace& trace, std::uint32_t step) {
  Ask asked;
  asked.step = step;
  asked.detail = look_at(trace, step);
  const std::optional<Question> question = evenlift::question(trace, asked.detail);
  if (!question) return std::nullopt;
  asked.question = *question;
  asked.text = question_text(trace, asked.detail, *question);
  // In their original order: a ranking would give the answer away.
  asked.choices = some_of(choices(trace, asked.detail, *question), question->answer);
  if (is_trivial(trace, asked)) return std::nullopt;
  return asked;
}

bool asks_anything(const AppState& state) {
  if (!walkthrough_is_open(state)) return true;  // its steps are still unknown
  const Trace& trace = *state.view.walkthrough.trace;
  const std::uint32_t count = timeline(state).count;
  for (std::uint32_t at = 0; at < count; ++at) {
    const std::uint32_t step = step_of(state, at);
    if (is_choice(trace, step) && question_of(trace, step)) return true;
  }
  return false;
}

}  // namespace

void ask(AppState& state, std::uint32_t step) {
  Walkthrough& walk = state.view.walkthrough;
  std::optional<Ask> asked = question_of(*walk.trace, step);
  if (!asked || !may_ask(walk, *asked)) return;
  asked->pointed = first_offered(*asked);
  // Remains of the preceding step would be among the choices.
  walk.answered.reset();
  walk.verdict.clear();
  forget_why(walk);
  walk.ask = std::move(asked);
  walk.playing = false;
  if (!walk.trace->balanced()) look_before_choice(walk);
  announce(state, walk.ask->text);
}

void set_predict(AppState& state, bool on) {
  if (on == state.view.walkthrough.predict) return;
  if (on && !asks_anything(state))
    return show(state, {Notice::Kind::info, "No step here has a choice to predict."});
  if (on) state.view.walkthrough.guesses = {};
  state.view.walkthrough.predict = on;
  show_step_again(state);  // a challenge shows less of some steps
}

void guess(AppState& state, std::uint32_t answer) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state) || !walk.ask) return;
  const Ask asked = *walk.ask;
  const bool right = answer == asked.question.answer;
  std::vector<std::uint32_t>& guessed = walk.guesses.steps;
  if (std::find(guessed.begin(), guessed.end(), asked.step) == guessed.end()) {
    guessed.push_back(asked.step);
    walk.guesses.right += right ? 1 : 0;
  }
  std::string verdict = say(right ? "Right." : "Not this time.");
  if (!right && asked.question.kind == QuestionKind::nearer_end)
    verdict = say(asked.question.answer == 0 ? "Not this time: it is the first end."
                                             : "Not this time: it is the second end.");
  if (!right && asked.question.kind == QuestionKind::winning_chord)
    verdict += " " + why_not_text(*walk.trace, why_not(*walk.trace, asked.step, answer));
  if (!right && asked.question.kind == QuestionKind::even_chord)
    verdict = say("Not this time: it is chord {chord}.", {asked.question.answer + 1}) + " " +
              even_chord_text(*walk.trace, asked.detail, answer);
  if (!right && asked.detail.swap)
    verdict += " " + other_swap_text(*walk.trace, asked.detail, asked.question, answer);
  if (walk.script && timeline(state).at + 1 < timeline(state).count)
    walk.script->position = timeline(state).at + 1;
  go_to_step(state, asked.step);
  walk.answered = {asked, answer};
  walk.verdict = verdict;
  walk.was_right = right;
  announce(state, verdict);
}

bool asks_of_other_robots(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  return walk.ask && walk.ask->question.kind == QuestionKind::even_chord &&
         walk.detail.step.kind != StepKind::mirror;
}

}  // namespace evenlift::view
