#include "walkthrough/questions.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/notice.h"
#include "walkthrough/ask_why.h"
#include "walkthrough/timeline.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
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
