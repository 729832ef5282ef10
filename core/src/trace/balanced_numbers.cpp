#include <algorithm>

#include "evenlift/placed_robots.h"
#include "trace/step_numbers.h"

namespace evenlift {

void StepNumbers::lever() {
  const BalancedDetail& balanced = *detail_.balanced;
  add("arm1", length(balanced.robots[0].position - trace_.centre));
  add("arm2", length(balanced.robots[1].position - trace_.centre));
  add("load", placement_.weight() / 2);
}

void StepNumbers::three() {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const Vec2 middle = (robots[0].position + robots[1].position) / 2;
  add("arm", length(robots[2].position - trace_.centre));
  add("arm_of_two", length(middle - trace_.centre));
  add("load", placement_.weight() / 3);
}

void StepNumbers::many() {
  const std::size_t robots = detail_.balanced->robots.size();
  count("robots", robots);
  add("load", placement_.weight() / static_cast<double>(robots));
}

void StepNumbers::rest() {
  const BalancedDetail& balanced = *detail_.balanced;
  count("robots", balanced.rest.size() + 2);
  count("placed", balanced.rest.size());
  point("middle_x", "middle_y", balanced.middle);
}

void StepNumbers::mirror() {
  rest();
  count("chords", detail_.balanced->chords.size());
}

void StepNumbers::completion() {
  mirror();
  count("chosen", detail_.balanced->chosen + std::size_t{1});
  count("stands", trace_.history.stands);
  add("coverage", detail_.balanced->keys.coverage);
}

void StepNumbers::robots_and_coverage() {
  count("robots", detail_.balanced->robots.size());
  add("coverage", detail_.balanced->keys.coverage);
  if (detail_.balanced->margin) add("margin", *detail_.balanced->margin);
}

void StepNumbers::start() {
  robots_and_coverage();
  count("kept", trace_.history.start[item_].kept.size());
}

void StepNumbers::exchange() {
  const BalancedDetail& balanced = *detail_.balanced;
  count("round", trace_.history.moves[item_].round + std::size_t{1});
  count("moved", balanced.moved.size());
  add("coverage_before", balanced.keys_before.coverage);
  if (balanced.margin_before) add("margin_before", *balanced.margin_before);
  robots_and_coverage();
}

void StepNumbers::round() {
  const auto& moves = trace_.history.moves;
  count("round", item_ + std::size_t{1});
  count("exchanges", static_cast<std::size_t>(std::count_if(
                         moves.begin(), moves.end(),
                         [&](const BalancedMove& move) { return move.round == item_; })));
  robots_and_coverage();
}

void StepNumbers::settled() {
  count("rounds", trace_.history.rounds);
  count("exchanges", trace_.history.moves.size());
  robots_and_coverage();
}

void StepNumbers::failure() {
  count("robot", item_ + std::size_t{1});
  const std::optional<RestOfRobots>& rest = detail_.balanced->rest_of[item_];
  count("carried", rest.has_value());
  if (!rest) return;
  count("steady", rest->clear);
  add("coverage", rest->coverage);
  count("form_closure", rest->form_closure);
  add("greatest", rest->greatest_by_springs);
}

void StepNumbers::failures() {
  const Robustness may_fail = robustness(placement_);
  add("failures_carried", may_fail.failures_carried);
  add("failures_steady", may_fail.failures_steady);
}

void StepNumbers::pairs() {
  const Placement& pairs = *trace_.in_pairs;
  const Robustness may_fail = robustness(pairs);
  count("teams", pairs.teams.size());
  add("coverage", pairs.coverage);
  count("form_closure", pairs.closure.form_closure);
  add("spread", pairs.loads->spread);
  add("failures_carried", may_fail.failures_carried);
  add("failures_steady", may_fail.failures_steady);
}

}  // namespace evenlift
