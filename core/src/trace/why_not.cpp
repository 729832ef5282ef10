// Explains why no balanced robot stands at a place.
#include "evenlift/why_not.h"

#include <algorithm>

#include "chords/radial_view.h"
#include "evenlift/plane.h"
#include "evenlift/tolerance.h"
#include "trace/step_rows.h"

namespace evenlift {
namespace {

LiftingPoint nearest_on_boundary(const Polygon& polygon, const Vec2& at) {
  LiftingPoint nearest{polygon.vertex(0), 0};
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const Vec2 p = nearest_on_segment(polygon.edge_start(edge), polygon.edge_end(edge), at);
    if (length(p - at) < length(nearest.position - at)) nearest = {p, edge};
  }
  return nearest;
}

bool has_robot(const std::vector<LiftingPoint>& robots, const Vec2& place) {
  return std::any_of(robots.begin(), robots.end(),
                     [&](const LiftingPoint& robot) { return robot.position == place; });
}

// Searches backwards for the move that put a robot at `place`.
void find_arrival(const Trace& trace, const BalancedSet& set, const Vec2& place,
                  WhyNoRobot& answer) {
  const BalancedHistory& history = trace.history;
  answer.why = WhyNoRobot::Why::stands_from_start;
  bool reached = false;
  for (std::size_t move = history.moves.size(); move-- > 0;) {
    reached = reached || &history.moves[move].set == &set;
    const std::vector<LiftingPoint>& before =
        move == 0 ? history.start.back().robots : history.moves[move - 1].set.robots;
    if (!reached || has_robot(before, place)) continue;
    answer.why = WhyNoRobot::Why::stands;
    answer.move = move;
    return;
  }
}

// Separates robots that stay from those that come, with the one at `place` first. A robot that
// comes to another's place stays.
void part_by_place(const std::vector<LiftingPoint>& before, const Vec2& place, BalancedSet& set) {
  for (const LiftingPoint& robot : set.robots)
    (has_robot(before, robot.position) ? set.kept : set.came).push_back(robot);
  std::stable_partition(set.came.begin(), set.came.end(),
                        [&](const LiftingPoint& robot) { return robot.position == place; });
}

SetComparison compare(const Trace& trace, const std::vector<LiftingPoint>& robots,
                      const std::vector<LiftingPoint>& now) {
  const BalancedProblem& problem = *trace.problem;
  SetComparison comparison;
  comparison.keys = balanced_keys(problem, robots);
  comparison.keys_now = balanced_keys(problem, now);
  comparison.margin = margin_of(trace, robots);
  comparison.margin_now = margin_of(trace, now);
  comparison.decided_by = decided_by(problem, robots, now).value_or(BalancedKey::places);
  comparison.better = is_better(problem, robots, now);
  return comparison;
}

}  // namespace

WhyNoRobot why_no_robot(const Trace& trace, std::uint32_t k, const Vec2& at, double reach) {
  WhyNoRobot answer;
  answer.place = nearest_on_boundary(trace.polygon(), at);
  const BalancedSet* set = balanced_set_at(trace, trace.step(k));
  if (!set || set->robots.size() < 3)
    set = balanced_set_at(trace, {StepKind::result, Chapter::grasp});
  if (!set || set->robots.size() < 3) return answer;
  const StepDetail detail = look_at(trace, k);
  const std::vector<LiftingPoint>& robots = set->robots;
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    if (length(robots[i].position - at) > reach) continue;
    const bool shown = detail.balanced && detail.balanced->robots.size() == robots.size();
    answer.robot = shown ? detail.balanced->numbers[i] : i;
    find_arrival(trace, *set, robots[i].position, answer);
    return answer;
  }
  const auto best = best_with_robot_at(*trace.problem, robots, answer.place);
  answer.why = best ? WhyNoRobot::Why::other_set : WhyNoRobot::Why::no_completion;
  if (!best) return answer;
  answer.set.robots = best->set.robots;
  part_by_place(robots, best->set.came.front().position, answer.set);
  answer.comparison = compare(trace, best->set.robots, robots);
  return answer;
}

SetComparison compare_even_chord(const Trace& trace, const StepDetail& detail,
                                 std::uint32_t choice) {
  const BalancedDetail& balanced = *detail.balanced;
  std::vector<LiftingPoint> robots = balanced.rest;
  robots.push_back(balanced.chords[choice].r1);
  robots.push_back(balanced.chords[choice].r2);
  return compare(trace, robots, balanced.robots);
}

namespace {

// The team that a question at step k concerns.
std::uint32_t team_at(const Trace& trace, std::uint32_t k) {
  const Step step = trace.step(k);
  if (step.kind == StepKind::scores || step.kind == StepKind::team || step.kind == StepKind::base)
    return step.item;
  const std::uint32_t taken = progress_at(trace, k).teams;
  return taken == 0 ? 0 : taken - 1;
}

// Also true if the point is at an end of the edge.
bool lies_on(const Trace& trace, const LiftingPoint& point, std::uint32_t edge) {
  if (point.edge == edge) return true;
  const double near = near_distance(trace.polygon().diameter());
  return length(point.position - trace.polygon().edge_start(edge)) <= near ||
         length(point.position - trace.polygon().edge_end(edge)) <= near;
}

bool lies_on(const Trace& trace, const Chord& chord, const EdgePair& pair) {
  const auto lies_from = [&](std::uint32_t a, std::uint32_t b) {
    return lies_on(trace, chord.r1, a) && lies_on(trace, chord.r2, b);
  };
  return lies_from(pair.a, pair.b) || lies_from(pair.b, pair.a);
}

bool is_same(const Trace& trace, const Chord& a, const Chord& b) {
  return same_chord(a, b, near_distance(trace.polygon().diameter()));
}

std::optional<std::uint32_t> candidate_at(const Trace& trace, const Chord& chord) {
  const std::vector<Candidate>& candidates = trace.placement.candidates;
  for (std::uint32_t i = 0; i < candidates.size(); ++i)
    if (is_same(trace, chord, candidates[i].chord)) return i;
  return std::nullopt;
}

bool can_stand(const Stands& stands, const Chord& chord) {
  return stands.can_lift(stands.lifting_point(chord.r1)) &&
         stands.can_lift(stands.lifting_point(chord.r2));
}

bool is_uneven_opposite(const Trace& trace, const Chord& chord) {
  for (std::uint32_t i = 0; i < trace.opposite.size(); ++i) {
    const OppositeDetail detail = look_at_opposite(trace, i);
    if (!detail.candidate && is_same(trace, chord, detail.chord)) return true;
  }
  return false;
}

// A chord that ends at a vertex may belong to several edge pairs. The one with the best chord tells
// most.
void answer_by_pair(const Trace& trace, const Chord& chord, WhyNot& answer) {
  answer.why = Why::no_pair;
  for (std::uint32_t i = 0; i < trace.pairs.size(); ++i) {
    if (!lies_on(trace, chord, trace.pairs[i])) continue;
    const PairDetail detail = look_at_pair(trace, i);
    if (answer.pair && detail.chosen.ratio <= answer.pair_ratio) continue;
    answer.pair = i;
    answer.pair_ratio = detail.chosen.ratio;
    answer.candidate = detail.candidate;
    answer.why = !detail.candidate                      ? Why::too_uneven
                 : is_same(trace, chord, detail.chosen) ? Why::duplicate
                                                        : Why::not_best_of_pair;
  }
}

constexpr std::size_t most_chords_through = 256;

std::vector<Chord> chords_through(const Trace& trace, const Vec2& direction) {
  std::vector<Chord> chords;
  if (!(length(direction) > 0)) return chords;
  const RayCaster rays(trace.polygon(), trace.centre);
  const auto ahead = rays.hits(direction), behind = rays.hits(-direction);
  for (const RayCaster::Hit& a : ahead) {
    for (const RayCaster::Hit& b : behind) {
      if (!(a.distance > 0 && b.distance > 0)) continue;
      if (chords.size() == most_chords_through) return chords;
      chords.push_back(order_ends(a.point, a.distance, b.point, b.distance, direction));
    }
  }
  return chords;
}

}  // namespace

WhyNot why_not(const Trace& trace, std::uint32_t k, std::uint32_t candidate) {
  WhyNot answer;
  answer.chord = trace.placement.candidates[candidate].chord;
  answer.candidate = candidate;
  answer.why = Why::not_by_candidates;
  if (!trace.by_candidates()) return answer;
  const std::uint32_t source = trace.source_of_candidate[candidate];
  if (source < trace.pairs.size()) answer.pair = source;
  answer.pair_ratio = answer.chord.ratio;
  answer.team = team_at(trace, k);
  if (trace.placement.teams.empty()) return answer;

  const std::vector<std::uint32_t>& taken = trace.selected();
  const auto at = std::find(taken.begin(), taken.end(), candidate);
  const auto by = static_cast<std::uint32_t>(at - taken.begin());
  if (at != taken.end() && by < answer.team) answer.team = by;
  const TeamScores scores = look_at_scores(trace, answer.team);
  const Score& own = scores.of_candidate[candidate];
  const std::uint32_t winner = scores.ranking.front();
  answer.winner = winner;
  answer.rank = static_cast<std::uint32_t>(
      std::find(scores.ranking.begin(), scores.ranking.end(), candidate) - scores.ranking.begin());
  answer.value = own.value;
  answer.best = scores.of_candidate[winner].value;
  answer.exact = own.exact;
  answer.rule = scores.rule;
  answer.decided_by = winner == candidate ? scores.decided_by : own.lost_by;
  answer.why = winner == candidate ? Why::taken
               : own.collides      ? Why::collides
               : own.eligible      ? Why::behind
                                   : Why::not_even;
  return answer;
}

std::optional<Chord> chord_at(const Trace& trace, const Vec2& point) {
  const Vec2 direction = point - trace.centre;
  const double wanted = length(direction);
  std::optional<Chord> best;
  bool reaches = false;
  for (const Chord& chord : chords_through(trace, direction)) {
    // On the point's side.
    const double arm = points_right(direction) ? chord.arm2 : chord.arm1;
    const bool reaches_it = arm >= wanted - near_distance(trace.polygon().diameter());
    const double size = chord.arm1 + chord.arm2, best_size = best ? best->arm1 + best->arm2 : 0;
    if (!best || (reaches_it && !reaches) ||
        (reaches_it == reaches && (reaches ? size < best_size : size > best_size))) {
      best = chord;
      reaches = reaches_it;
    }
  }
  return best;
}

WhyNot why_not_chord(const Trace& trace, std::uint32_t k, const std::optional<Chord>& chord) {
  WhyNot answer;
  if (!chord) return answer;
  answer.chord = *chord;
  answer.why = Why::not_by_candidates;
  if (!trace.by_candidates()) return answer;
  if (const auto candidate = candidate_at(trace, *chord)) return why_not(trace, k, *candidate);
  const Stands* stands = trace.placement.stands.get();
  if (stands && !can_stand(*stands, *chord))
    answer.why = Why::cannot_stand;
  else if (is_uneven_opposite(trace, *chord))
    answer.why = Why::opposite_too_uneven;
  else
    answer_by_pair(trace, *chord, answer);
  return answer;
}

}  // namespace evenlift
