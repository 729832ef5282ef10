#include "trace/step_rows.h"

#include <algorithm>

#include "evenlift/angles.h"
#include "evenlift/placed_robots.h"
#include "evenlift/selection.h"
#include "evenlift/stability.h"

namespace evenlift {

void StepNumbers::point(std::string_view x, std::string_view y, const Vec2& p) {
  add(x, p.x);
  add(y, p.y);
}

void StepNumbers::polygon() {
  count("vertices", trace_.polygon().size());
  add("area", trace_.object().area());
  if (trace_.object().holes().empty()) return;
  count("holes", trace_.object().holes().size());
  add("outline_area", trace_.polygon().area());
}

void StepNumbers::centroid() { point("centroid_x", "centroid_y", trace_.object().centroid()); }

void StepNumbers::centre() {
  point("x", "y", trace_.centre);
  add("moved_by", length(trace_.centre - trace_.object().centroid()));
  if (!placement_.settings.cargo.empty()) point("own_x", "own_y", placement_.own_centre);
}

void StepNumbers::radial() { count("edges", trace_.radial_edges.size()); }

void StepNumbers::ray() {
  const Trace::Rays& rays = trace_.rays;
  count("vertex", rays.vertices[item_] + 1);
  count("chords", rays.begins[item_ + 1] - rays.begins[item_]);
}

void StepNumbers::slopes() { count("chords", chords_by_slope(trace_).size()); }

void StepNumbers::sections() {
  const PairDetail& pair = *detail_.pair;
  count("pair", item_ + 1);
  count("edge_a", pair.pair.a + 1);
  count("edge_b", pair.pair.b + 1);
  add("g0", pair.verdict.g0);
  add("g1", pair.verdict.g1);
}

void StepNumbers::outcome() {
  sections();
  ratio_and_candidate(detail_.pair->chosen.ratio, detail_.pair->candidate);
}

void StepNumbers::opposite() {
  const OppositeDetail& opposite = *detail_.opposite;
  count("vertex_v", opposite.vertices.v + std::size_t{1});
  count("vertex_w", opposite.vertices.w + std::size_t{1});
  ratio_and_candidate(opposite.chord.ratio, opposite.candidate);
}

void StepNumbers::ratio_and_candidate(double ratio, std::optional<std::uint32_t> candidate) {
  add("ratio", ratio);
  add("min_ratio", placement_.settings.min_ratio);
  if (candidate) count("candidate", *candidate + std::size_t{1});
}

void StepNumbers::duplicates() {
  const auto& candidates = trace_.candidate_of_source;
  const auto none = std::count(candidates.begin(), candidates.end(), no_index);
  count("merged", candidates.size() - static_cast<std::size_t>(none) + 2 * trace_.ranges.size() -
                      placement_.candidates.size());
  count("candidates", placement_.candidates.size());
}

void StepNumbers::candidates() {
  const std::vector<Candidate>& all = placement_.candidates;
  count("candidates", all.size());
  const auto even =
      std::count_if(all.begin(), all.end(), [](const Candidate& c) { return is_even(c.chord); });
  count("even", static_cast<std::size_t>(even));
}

void StepNumbers::directions() {
  add("open_degrees", 180 / pi * open_directions_rad(trace_.polygon(), trace_.centre));
}

void StepNumbers::scores() {
  count("team", item_ + 1);
  if (!detail_.scores) return;
  const TeamScores& scores = *detail_.scores;
  const std::uint32_t winner = scores.ranking.front();
  count("choices", scores.ranking.size());
  count("winner", winner + 1);
  add("best", scores.of_candidate[winner].value);
  if (scores.ranking.size() < 2) return;
  count("second", scores.ranking[1] + 1);
  add("second_best", scores.of_candidate[scores.ranking[1]].value);
}

void StepNumbers::team() {
  scores();
  add("ratio", trace_.selected_teams()[item_].ratio);
}

void StepNumbers::range() {
  const RangeDetail& range = *detail_.range;
  count("edge_a", range.pair.a + std::size_t{1});
  count("edge_b", range.pair.b + std::size_t{1});
  add("first_ratio", range.ends[0].ratio);
  add("last_ratio", range.ends[1].ratio);
  count("first_candidate", range.candidates[0] + std::size_t{1});
  if (range.candidates[1] != no_index)
    count("last_candidate", range.candidates[1] + std::size_t{1});
}

void StepNumbers::swap() {
  const SwapDetail& swap = *detail_.swap;
  count("exchange", item_ + std::size_t{1});
  count("moved", swap.teams.size());
  if (swap.teams.size() == 1) {
    count("team", swap.teams[0] + std::size_t{1});
    count("from", swap.from[0] + std::size_t{1});
    count("to", swap.to[0] + std::size_t{1});
  }
  count("level_before", swap.before.level);
  count("level", swap.after.level);
  add("coverage_before", swap.before.coverage);
  add("coverage", swap.after.coverage);
  add("ratios_before", swap.before.ratios);
  add("ratios", swap.after.ratios);
}

void StepNumbers::held() {
  count("exchanges", trace_.swaps->swaps.size());
  count("form_closure", placement_.closure.form_closure);
  add("coverage", placement_.coverage);
}

void StepNumbers::base() {
  count("team", item_ + 1);
  count("corners_before", detail_.base_before.size());
  count("corners", detail_.base.size());
  add("coverage_before", evenlift::coverage(trace_.object(), detail_.base_before));
  add("coverage", evenlift::coverage(trace_.object(), detail_.base));
}

void StepNumbers::fewer() {
  count("teams", placement_.teams.size());
  count("requested_teams", placement_.requested_teams);
}

void StepNumbers::share() {
  const Team& team = placement_.teams[item_];
  count("team", item_ + 1);
  add("arm1", team.robots[0].arm);
  add("arm2", team.robots[1].arm);
  add("load1", team.robots[0].load);
  add("load2", team.robots[1].load);
}

void StepNumbers::loads() {
  add("min", placement_.loads->min);
  add("mean", placement_.loads->mean);
  add("max", placement_.loads->max);
  add("spread", placement_.loads->spread);
  add("max_share", placement_.loads->max_share);
}

void StepNumbers::coverage() { add("coverage", placement_.coverage); }

void StepNumbers::contacts() {
  count("robots", count_robots(placement_.teams));
  count("contacts", trace_.contacts.size());
}

void StepNumbers::cut() {
  count("contact", item_ + 1);
  count("clockwise", detail_.clockwise.exists);
  count("counterclockwise", detail_.counterclockwise.exists);
}

void StepNumbers::slide() {
  count("translation", placement_.closure.translation_free);
  if (const auto& way = placement_.closure.translation) point("x", "y", *way);
}

void StepNumbers::closure() {
  count("form_closure", placement_.closure.form_closure);
  if (placement_.closure.margin) add("margin", *placement_.closure.margin);
}

void StepNumbers::second_order() { count("second_order", placement_.closure.second_order); }

void StepNumbers::result() {
  count("teams", placement_.teams.size());
  add("coverage", placement_.coverage);
  count("form_closure", placement_.closure.form_closure);
  if (!trace_.moved) return;
  add("moved_coverage", trace_.moved->coverage);
  count("moved_form_closure", trace_.moved->closure.form_closure);
}

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
  const std::optional<RestOfRobots>& rest = trace_.report.failures[item_];
  count("carried", rest.has_value());
  if (!rest) return;
  count("steady", rest->clear);
  add("coverage", rest->coverage);
  count("form_closure", rest->form_closure);
  add("greatest", rest->greatest_by_springs);
}

void StepNumbers::failures() {
  const Robustness& may_fail = trace_.report.robustness;
  add("failures_carried", may_fail.failures_carried);
  add("failures_steady", may_fail.failures_steady);
}

void StepNumbers::pairs() {
  const Placement& pairs = *trace_.in_pairs;
  const Robustness& may_fail = trace_.report_of_pairs.robustness;
  count("teams", pairs.teams.size());
  add("coverage", pairs.coverage);
  count("form_closure", pairs.closure.form_closure);
  add("spread", pairs.loads->spread);
  add("failures_carried", may_fail.failures_carried);
  add("failures_steady", may_fail.failures_steady);
}

}  // namespace evenlift
