#include "walkthrough/words.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "walkthrough/script.h"
#include "walkthrough/timeline.h"

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

}  // namespace evenlift::view
