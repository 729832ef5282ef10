#include "selection/greedy_selector.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "selection/tie_order.h"

namespace evenlift {
namespace {

// For score_slack(). Rounding the ends of a short edge turns its line, which moves far at a distant
// vertex. So the floor for `distance` grows as the shortest edge shrinks.
double floor_of(double size, Metric metric, const Points& hull) {
  if (!scores_are_lengths(metric)) return score_floor * size * size;
  double shortest = short_edge * size;
  for (std::size_t i = 0; i < hull.size(); ++i)
    shortest = std::min(shortest, length(hull[(i + 1) % hull.size()] - hull[i]));
  return score_floor * size * (short_edge * size / shortest);
}

}  // namespace

Selector::Selector(const PolygonWithHoles& object, const Vec2& centre,
                   const std::vector<Candidate>& candidates, Metric metric, std::size_t most_teams,
                   FirstTeam first, const Stands* stands)
    : candidates_(candidates),
      surroundings_(object, centre),
      metric_(metric),
      most_teams_(most_teams),
      first_(first),
      near_(near_distance(object.outline().diameter())),
      floor_(floor_of(object.outline().diameter(), metric, {})),
      stands_(stands),
      states_(candidates.size(), State::open) {
  ends_.reserve(2 * candidates.size());
  for (const Candidate& candidate : candidates) {
    for (const LiftingPoint* point : {&candidate.chord.r1, &candidate.chord.r2}) {
      const Vec2 relative = point->position - centre;
      ends_.push_back({relative, pseudo_angle(relative), 0, {}, {}});
    }
  }
  // Pairs of pseudo-angle and index sort twice as fast as indices alone.
  std::vector<std::pair<double, Index>> ends;
  ends.reserve(ends_.size());
  for (Index i = 0; i < ends_.size(); ++i) ends.emplace_back(ends_[i].pseudo_angle, i);
  std::sort(ends.begin(), ends.end());
  by_direction_.reserve(ends.size());
  for (const auto& [angle, index] : ends) by_direction_.push_back(index);
}

bool Selector::take_next() {
  if (out_ == candidates_.size()) return false;
  if (taken_.empty()) {
    Indices all(candidates_.size());
    std::iota(all.begin(), all.end(), Index{0});
    take(best_by(rule_of_first_team(candidates_, first_), std::move(all)));
    return true;
  }
  if (!line_.empty()) {
    const Index next = line_.back();
    take(next);
    return true;
  }
  Indices leaders = find_leaders();
  const Points before = hull_;
  take(best_by(Rule::score, leaders));
  if (hull_ == before) line_up(std::move(leaders));
  return true;
}

void Selector::take(std::uint32_t candidate) {
  taken_.push_back(candidate);
  states_[candidate] = State::taken;
  ++out_;
  const bool was_best = !line_.empty() && bound(candidate) == best_score_;
  if (!line_.empty()) line_.pop_back();
  if (widen_base(candidate) || (was_best && --best_in_line_ == 0)) line_.clear();
  if (stands_) drop_colliding(candidate);
}

// Also clears the line, since another of the tied candidates may now be first.
void Selector::drop_colliding(Index taken) {
  const Chord& team = candidates_[taken].chord;
  const auto collides = [&](const LiftingPoint& point) {
    return stands_->collide(point, team.r1) || stands_->collide(point, team.r2);
  };
  for (Index i = 0; i < candidates_.size(); ++i) {
    if (!is_open(i)) continue;
    if (!collides(candidates_[i].chord.r1) && !collides(candidates_[i].chord.r2)) continue;
    states_[i] = State::dropped;
    ++out_;
  }
  line_.clear();
}

double Selector::score(std::uint32_t candidate) {
  for (End* end : {&ends_[2 * candidate], &ends_[2 * candidate + 1]})
    if (!end->gain.exact()) evaluate(*end);
  return bound(candidate);
}

double Selector::evaluate(const End& end, Index wedge) const {
  return gains(wedges_[wedge], end.position) ? wedges_[wedge].evaluate(end.position) : 0;
}

// Of two wedges, the one with the larger gain becomes the end's first.
void Selector::evaluate(End& end) {
  end.gain = {evaluate(end, end.wedge), Certainty::exact};
  if (!end.other_wedge) return;
  const double other = evaluate(end, *end.other_wedge);
  if (other <= end.gain.value) return;
  end.gain.value = other;
  std::swap(end.wedge, *end.other_wedge);
}

// Takes one step, at the less certain end of an inexact candidate.
void Selector::sharpen(Index candidate) {
  End &first = ends_[2 * candidate], &second = ends_[2 * candidate + 1];
  End& end = first.gain.certainty <= second.gain.certainty ? first : second;
  if (end.other_wedge) return evaluate(end);
  end.gain = wedges_[end.wedge].sharpen(end.position, end.gain);
}

Selector::Index Selector::best_by(Rule rule, Indices indices) const {
  std::erase_if(indices, [&](Index i) { return !is_eligible(rule, candidates_[i]); });
  for (const Key key : keys_of(rule))
    keep_best(indices, key, floor_,
              [&](Index i) { return value_of(key, candidates_[i], bound(i)); });
  return indices.front();
}

// Lazy greedy selection (greedy_selector.h) evaluates the largest bound first. Open candidates that
// cannot tie with the best keep their bounds.
double Selector::find_best_score() {
  double best = -std::numeric_limits<double>::infinity();
  Indices open;  // without exact gains
  for (Index i = 0; i < candidates_.size(); ++i) {
    if (!is_open(i)) continue;
    if (exact(i))
      best = std::max(best, bound(i));
    else
      open.push_back(i);
  }
  const auto smaller_bound = [&](Index a, Index b) {
    return bound(a) != bound(b) ? bound(a) < bound(b) : a > b;
  };
  // Candidates that cannot tie with the best so far need not enter the heap.
  if (!open.empty())
    best = std::max(best, score(*std::max_element(open.begin(), open.end(), smaller_bound)));
  std::erase_if(open, [&](Index i) { return exact(i) || !ties(best, bound(i)); });
  std::make_heap(open.begin(), open.end(), smaller_bound);
  while (!open.empty() && ties(best, bound(open.front()))) {
    std::pop_heap(open.begin(), open.end(), smaller_bound);
    const Index next = open.back();
    sharpen(next);
    if (exact(next)) best = std::max(best, bound(next));
    if (exact(next) || !ties(best, bound(next)))
      open.pop_back();
    else
      std::push_heap(open.begin(), open.end(), smaller_bound);
  }
  return best;
}

// Evaluates and returns the open candidates that tie for the best score, in candidate order.
Selector::Indices Selector::find_leaders() {
  best_score_ = find_best_score();
  Indices leaders;
  for (Index i = 0; i < candidates_.size(); ++i)
    if (is_open(i) && exact(i) && ties(best_score_, bound(i))) leaders.push_back(i);
  return leaders;
}

void Selector::line_up(Indices leaders) {
  std::erase_if(leaders, [&](Index i) { return !is_open(i); });
  best_in_line_ = static_cast<std::size_t>(std::count_if(
      leaders.begin(), leaders.end(), [&](Index i) { return bound(i) == best_score_; }));
  if (best_in_line_ == 0) return;
  const std::size_t needed = std::max<std::size_t>(most_teams_ - taken_.size(), 1);
  line_ = order_of_taking(candidates_, std::move(leaders), needed);
  std::reverse(line_.begin(), line_.end());
}

// Returns whether H changed. O(h) for h corners, plus new wedges.
bool Selector::widen_base(Index candidate) {
  Points hull =
      widen_hull(hull_, ends_[2 * candidate].position, ends_[2 * candidate + 1].position, near_);
  if (hull == hull_) return false;
  const Points old_hull = std::exchange(hull_, std::move(hull));
  floor_ = floor_of(surroundings_.diameter, metric_, hull_);
  const Indices old_edges = std::exchange(edges_, {});

  const auto corner = [](const Points& corners, std::size_t i) -> const Vec2& {
    return corners[i % corners.size()];
  };
  // Corners that stay have the same order in both hulls, and at most two are new. Each search
  // starts at the last corner found: O(h) in all.
  std::size_t found = 0;
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    const Vec2 &h1 = hull_[i], &h2 = corner(hull_, i + 1);
    std::size_t steps = 0;
    while (steps < old_hull.size() && corner(old_hull, found + steps) != h1) ++steps;
    if (steps < old_hull.size()) {
      found = (found + steps) % old_hull.size();
      // The sides of a segment H never stay, since points on its line follow a special rule.
      if (old_hull.size() > 2 && corner(old_hull, found + 1) == h2) {
        edges_.push_back(old_edges[found]);
        continue;
      }
    }
    edges_.push_back(static_cast<Index>(wedges_.size()));
    wedges_.emplace_back(surroundings_, metric_, h1, h2);
    enter_wedge(edges_.back());
  }
  return true;
}

// Assigns to a new wedge the ends that C sees in it.
void Selector::enter_wedge(Index index) {
  const Wedge& wedge = wedges_[index];
  // Whether `other` is beyond the corner in the direction of the end.
  const auto is_beyond_corner = [&](Index other, SeenAt seen_at) {
    if (other == index) return false;
    return seen_at == SeenAt::first_corner ? wedges_[other].h2() == wedge.h1()
                                           : wedges_[other].h1() == wedge.h2();
  };
  for_each_between(
      by_direction_, [&](Index end) -> const End& { return ends_[end]; }, wedge.h1(), wedge.h2(),
      [&](Index i, SeenAt seen_at) {
        End& end = ends_[i];
        std::optional<Index> other;
        if (seen_at != SeenAt::between) {
          if (end.other_wedge && is_beyond_corner(*end.other_wedge, seen_at))
            other = end.other_wedge;
          else if (is_beyond_corner(end.wedge, seen_at))
            other = end.wedge;
        }
        end.wedge = index;
        end.other_wedge = other;
        end.gain = estimate(end);
      });
}

// The gain if it is cheap, otherwise an upper bound.
Gain Selector::estimate(const End& end) const {
  const auto by = [&](Index wedge) {
    return gains(wedges_[wedge], end.position) ? wedges_[wedge].estimate(end.position) : Gain{};
  };
  const Gain gain = by(end.wedge);
  if (!end.other_wedge) return gain;
  const double larger = std::max(gain.value, by(*end.other_wedge).value);
  return {larger, larger == 0 ? Certainty::exact : Certainty::bound};
}

// Whether p, which C sees in the wedge, is outside H by more than the tolerance. If H is a segment,
// its whole line counts as H.
bool Selector::gains(const Wedge& wedge, const Vec2& p) const {
  const double distance = wedge.distance(p);
  if (distance <= 0) return false;
  if (distance > near_) return true;
  if (hull_.size() <= 2) return false;
  // Near the line, p may still be far from H, beyond a corner.
  for (std::size_t i = 0; i < hull_.size(); ++i) {
    if (distance_to_segment(hull_[i], hull_[(i + 1) % hull_.size()], p) <= near_) return false;
  }
  return true;
}

}  // namespace evenlift
