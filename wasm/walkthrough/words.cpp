#include "walkthrough/words.h"

#include <cstdint>

#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "walkthrough/script.h"
#include "walkthrough/timeline.h"

namespace evenlift::view {

std::string place_in_words(const AppState& state) {
  const Timeline now = timeline(state);
  return std::to_string(now.at + 1) + " of " + std::to_string(now.count);
}

std::string left_out_in_words(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.trace || walk.script || walk.all_steps || walk.ask) return {};
  const Step& step = walk.detail.step;
  const std::uint32_t more = further_like(*walk.trace, step);
  if (more == 0) return {};
  const std::string number = std::to_string(more);
  if (step.kind == StepKind::team)
    return number + (more == 1 ? " more team is" : " more teams are") +
           " chosen like this before the last: “All steps” shows them.";
  if (step.kind == StepKind::exchange)
    return number + (more == 1 ? " smaller swap is" : " smaller swaps are") +
           " left out here: “All steps” shows them.";
  if (step.kind == StepKind::start)
    return number + (more == 1 ? " smaller set is" : " smaller sets are") +
           " made on the way: “All steps” shows them.";
  if (step.kind == StepKind::cargo)
    return number + (more == 1 ? " more item of cargo is" : " more items of cargo are") +
           " left out here: “All steps” shows them.";
  return std::string("There ") + (more == 1 ? "is " : "are ") + number + " more " +
         (step.kind == StepKind::ray ? (more == 1 ? "ray" : "rays")
                                     : (more == 1 ? "pair" : "pairs")) +
         " like it: “All steps” shows " + (more == 1 ? "it." : "them.");
}

std::string walkthrough_in_words(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.trace) return {};
  std::string text =
      "Step " + place_in_words(state) + ", " + std::string(title(walk.detail.step.chapter)) + ". ";
  if (!walk.verdict.empty()) text += walk.verdict + " ";
  if (const std::string words = words_of_stop(state); !words.empty()) text += words + " ";
  text += walk.caption;
  if (!walk.formula.empty()) text += " " + walk.formula + ".";
  if (const std::string more = left_out_in_words(state); !more.empty()) text += " " + more;
  if (walk.ask) text += " " + walk.ask->text;
  return text;
}

}  // namespace evenlift::view
