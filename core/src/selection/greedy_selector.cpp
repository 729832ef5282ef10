#include "selection/greedy_selector.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"

namespace evenlift {
namespace {

// From here on it pays to change only a few edges.
constexpr std::size_t many_corners = 64;

}  // namespace

Points GrowingBase::positions() const {
  Points positions;
  positions.reserve(size_);
  for (Corner corner = first_; positions.size() < size_; corner = next(corner))
    positions.push_back(position(corner));
  return positions;
}

bool GrowingBase::is_near(const Vec2& p, double distance) const {
  Corner corner = first_;
  for (std::size_t i = 0; i < size_; ++i, corner = next(corner))
    if (distance_to_segment(position(corner), position(next(corner)), p) <= distance) return true;
  return false;
}

std::vector<GrowingBase::Corner> GrowingBase::add(const Added& p, const Added& q) {
  if (size_ >= many_corners)
    if (auto starts = add_locally(p, q)) return *std::move(starts);
  return replace(widen_hull(positions(), p.position, q.position, flat_));
}

double GrowingBase::side(Corner edge, const Vec2& p) const {
  return orient(position(edge), position(next(edge)), p);
}

bool GrowingBase::is_straight(const Vec2& before, Corner corner, const Vec2& after) const {
  return is_straight_corner(before, position(corner), after, flat_);
}

// nullopt if neither an edge that p is beyond nor a triangle from C to an edge with p in it is
// found, or if rounding may be what makes a corner next to p: then the whole hull matters.
std::optional<GrowingBase::Gap> GrowingBase::gap_for(const Added& added) const {
  if (!added.edge || !has(*added.edge)) return std::nullopt;
  const Vec2& p = added.position;
  const Corner edge = *added.edge;
  const Corner edges[] = {edge, next(edge), corners_[edge].previous};
  for (const Corner e : edges)
    if (side(e, p) < 0) return widest_gap(e, p);
  const auto is_seen_in = [&](Corner e) {
    const Vec2 &h1 = position(e), &h2 = position(next(e)), centre{};
    return orient(h1, h2, centre) > 0 && orient(centre, h1, p) >= 0 && orient(centre, h2, p) <= 0;
  };
  if (std::any_of(std::begin(edges), std::end(edges), is_seen_in)) return Gap{true};
  return std::nullopt;
}

std::optional<GrowingBase::Gap> GrowingBase::widest_gap(Corner visible, const Vec2& p) const {
  if (is_straight_corner(position(visible), p, position(next(visible)), flat_)) return Gap{true};
  // The edges that p is beyond or in line with.
  std::size_t number = 1;
  Corner before = visible, after = next(visible);
  const auto previous = [&](Corner corner) { return corners_[corner].previous; };
  for (; number < size_ && side(previous(before), p) <= 0; ++number) before = previous(before);
  for (; number < size_ && side(after, p) <= 0; ++number) after = next(after);
  if (number + 2 > size_) return std::nullopt;
  // Rounding alone may now explain one corner on either side. Only the whole hull shows whether
  // several such corners are one run.
  if (is_straight(p, after, position(next(after)))) after = next(after);
  if (is_straight(position(previous(before)), before, p)) before = previous(before);
  if (is_straight(p, after, position(next(after))) ||
      is_straight(position(previous(before)), before, p) ||
      is_straight_corner(position(before), p, position(after), flat_))
    return std::nullopt;
  return Gap{false, before, after};
}

void GrowingBase::link(Corner from, Corner to) {
  corners_[from].next = to;
  corners_[to].previous = from;
}

// Puts p in its gap, in place of the corners there.
GrowingBase::Put GrowingBase::put(const Vec2& p, const Gap& gap) {
  const Put done{gap, next(gap.before), corners_[gap.after].previous, first_, size_};
  const auto corner = static_cast<Corner>(corners_.size());
  for (Corner out = done.next; out != gap.after; out = next(out), --size_)
    corners_[out].in_ring = false;
  corners_.push_back({p});
  ++size_;
  link(gap.before, corner);
  link(corner, gap.after);
  if (!has(first_)) first_ = corner;  // a straight corner, which is beside p
  for (const Corner other : {gap.before, corner, gap.after})
    if (lexicographically_before(position(other), position(first_))) first_ = other;
  return done;
}

void GrowingBase::take_out(const Put& put) {
  corners_.pop_back();
  corners_[put.gap.before].next = put.next;
  corners_[put.gap.after].previous = put.previous;
  for (Corner back = put.next; back != put.gap.after; back = next(back))
    corners_[back].in_ring = true;
  first_ = put.first;
  size_ = put.size;
}

std::optional<std::vector<GrowingBase::Corner>> GrowingBase::add_locally(const Added& p,
                                                                         const Added& q) {
  std::vector<Corner> starts;
  std::optional<Put> undo;
  for (const Added& added : {p, q}) {
    const auto gap = gap_for(added);
    if (!gap) {
      if (undo) take_out(*undo);
      return std::nullopt;
    }
    if (gap->inside) continue;
    starts.insert(starts.end(), {gap->before, static_cast<Corner>(corners_.size())});
    undo = put(added.position, *gap);
  }
  std::erase_if(starts, [&](Corner corner) { return !has(corner); });
  sort_indices(starts, [&](Corner a, Corner b) {
    if (a == first_ || b == first_) return a == first_ && b != first_;
    return orient(position(first_), position(a), position(b)) > 0;
  });
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  return starts;
}

// Corners that stay have the same order in both hulls, and at most two are new. Each search starts
// at the last corner found: O(h) in all.
std::vector<GrowingBase::Corner> GrowingBase::replace(const Points& positions) {
  if (positions == this->positions()) return {};
  std::vector<Corner> old, now;
  std::vector<std::optional<Corner>> next_before;  // of each corner now, if it stays
  for (Corner corner = first_; old.size() < size_; corner = next(corner)) old.push_back(corner);
  for (const Corner corner : old) corners_[corner].in_ring = false;
  std::size_t found = 0;
  for (const Vec2& position : positions) {
    std::size_t steps = 0;
    const auto at = [&](std::size_t i) { return old[(found + i) % old.size()]; };
    while (steps < old.size() && this->position(at(steps)) != position) ++steps;
    if (steps == old.size()) {
      now.push_back(static_cast<Corner>(corners_.size()));
      next_before.push_back(std::nullopt);
      corners_.push_back({position});
      continue;
    }
    found = (found + steps) % old.size();
    now.push_back(old[found]);
    next_before.push_back(next(old[found]));
    corners_[old[found]].in_ring = true;
  }
  first_ = now.front();
  size_ = now.size();
  std::vector<Corner> starts;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Corner following = now[(i + 1) % now.size()];
    // The sides of a segment never stay, since points on its line follow a special rule.
    if (old.size() <= 2 || next_before[i] != following) starts.push_back(now[i]);
    link(now[i], following);
  }
  return starts;
}

Selector::Selector(const PolygonWithHoles& object, const Vec2& centre,
                   const std::vector<Candidate>& candidates, Metric metric, FirstTeam first,
                   const Stands* stands)
    : candidates_(candidates),
      surroundings_(object, centre),
      metric_(metric),
      first_(first),
      near_(near_distance(object.outline().diameter())),
      floor_(score_floor * surroundings_.diameter *
             (scores_are_lengths(metric) ? 1 : surroundings_.diameter)),
      base_(near_),
      stands_(stands),
      states_(candidates.size(), State::open),
      by_evenness_(candidates.size()),
      place_(candidates.size()),
      standings_(candidates.size()) {
  ends_.reserve(2 * candidates.size());
  for (const Candidate& candidate : candidates) {
    for (const LiftingPoint* point : {&candidate.chord.r1, &candidate.chord.r2}) {
      const Vec2 relative = point->position - centre;
      ends_.push_back({relative, pseudo_angle(relative), 0, {}, {}});
    }
  }
  std::iota(by_evenness_.begin(), by_evenness_.end(), Index{0});
  std::stable_partition(by_evenness_.begin(), by_evenness_.end(),
                        [&](Index i) { return is_even(candidates_[i].chord); });
  for (Index place = 0; place < place_.size(); ++place) place_[by_evenness_[place]] = place;
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
    update_standings();
    take(best_by(rule_of_first_team(candidates_, first_)));
  } else {
    find_best_score();
    take(best_by(Rule::score));
  }
  return true;
}

void Selector::take(std::uint32_t candidate) {
  taken_.push_back(candidate);
  drop(candidate, State::taken);
  widen_base(candidate);
  if (stands_) drop_colliding(candidate);
}

void Selector::drop(Index candidate, State state) {
  states_[candidate] = state;
  ++out_;
  touch(candidate);
}

void Selector::drop_colliding(Index taken) {
  const Chord& team = candidates_[taken].chord;
  const auto collides = [&](const LiftingPoint& point) {
    return stands_->collide(point, team.r1) || stands_->collide(point, team.r2);
  };
  for (Index i = 0; i < candidates_.size(); ++i) {
    if (states_[i] != State::open) continue;
    if (collides(candidates_[i].chord.r1) || collides(candidates_[i].chord.r2))
      drop(i, State::dropped);
  }
}

double Selector::score(std::uint32_t candidate) {
  for (End* end : {&ends_[2 * candidate], &ends_[2 * candidate + 1]})
    if (!end->gain.exact()) evaluate(*end);
  touch(candidate);
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
  touch(candidate);
  if (end.other_wedge) return evaluate(end);
  end.gain = wedges_[end.wedge].sharpen(end.position, end.gain);
}

void Selector::Standing::raise_to(const Standing& other) {
  for (const auto value :
       {&Standing::score, &Standing::bound, &Standing::ratio, &Standing::length, &Standing::before})
    this->*value = std::max(this->*value, other.*value);
}

double Selector::Standing::of(Key key) const {
  return key == Key::score ? score : key == Key::ratio ? ratio : length;
}

Selector::Standing Selector::standing(Index candidate) const {
  if (states_[candidate] != State::open) return {};
  const double score = bound(candidate);
  return {exact(candidate) ? score : Standing::none, exact(candidate) ? Standing::none : score,
          candidates_[candidate].chord.ratio, candidates_[candidate].length,
          -static_cast<double>(candidate)};
}

void Selector::update_standings() {
  standings_.update([&](Index place) { return standing_at(place); });
}

template <class Value, class Passes>
double Selector::greatest(Value value, Passes passes) const {
  return standings_.greatest([&](Index place) { return standing_at(place); }, value, passes);
}

template <class Passes>
Selector::Index Selector::first(Passes passes) const {
  return static_cast<Index>(-greatest([](const Standing& s) { return s.before; }, passes));
}

// At each key, the candidates that tie with the best of those left stay.
Selector::Index Selector::best_by(Rule rule) const {
  const std::span<const Key> keys = keys_of(rule);
  std::vector<double> best;
  const auto passes = [&](const Standing& s) {
    if (!is_eligible(rule, s.ratio)) return false;
    for (std::size_t k = 0; k < best.size(); ++k) {
      const double value = s.of(keys[k]);
      if (value < best[k] && !ties(keys[k], best[k], value, floor_)) return false;
    }
    return true;
  };
  for (const Key key : keys)
    best.push_back(greatest([&](const Standing& s) { return s.of(key); }, passes));
  return first(passes);
}

// Lazy greedy selection (greedy_selector.h) evaluates the largest bound first. Open candidates that
// cannot tie with the best keep their bounds.
void Selector::find_best_score() {
  update_standings();
  const double largest = standings_.greatest().bound;
  double best = standings_.greatest().score;
  const auto can_tie = [&](double bound) { return ties(Key::score, best, bound, floor_); };
  if (largest == Standing::none || !can_tie(largest)) return;
  best = std::max(best, score(first([&](const Standing& s) { return s.bound >= largest; })));
  Indices open;  // without exact gains
  standings_.for_each(
      [&](Index place) { return standing_at(place); },
      [&](const Standing& s) { return s.bound > Standing::none && can_tie(s.bound); },
      [&](Index place) { open.push_back(by_evenness_[place]); });
  const auto smaller_bound = [&](Index a, Index b) {
    return bound(a) != bound(b) ? bound(a) < bound(b) : a > b;
  };
  std::make_heap(open.begin(), open.end(), smaller_bound);
  while (!open.empty() && can_tie(bound(open.front()))) {
    std::pop_heap(open.begin(), open.end(), smaller_bound);
    const Index next = open.back();
    sharpen(next);
    if (exact(next)) best = std::max(best, bound(next));
    if (exact(next) || !can_tie(bound(next)))
      open.pop_back();
    else
      std::push_heap(open.begin(), open.end(), smaller_bound);
  }
  update_standings();
}

void Selector::widen_base(Index candidate) {
  const auto added = [&](const End& end) -> GrowingBase::Added {
    if (wedges_.empty() || !is_edge(end.wedge)) return {end.position, {}};
    return {end.position, starts_[end.wedge]};
  };
  const Indices starts = base_.add(added(ends_[2 * candidate]), added(ends_[2 * candidate + 1]));
  const auto first_new = static_cast<Index>(wedges_.size());
  for (const Index start : starts) {
    const auto wedge = static_cast<Index>(wedges_.size());
    wedges_.emplace_back(surroundings_, metric_, base_.position(start),
                         base_.position(base_.next(start)));
    starts_.push_back(start);
    wedge_at_.resize(std::max<std::size_t>(wedge_at_.size(), start + 1));
    wedge_at_[start] = wedge;
    enter_wedge(wedge);
  }
  if (!starts.empty()) update_floor(first_new);
}

// For score_slack(). Rounding the ends of a short edge turns its line, which moves far at a distant
// vertex. So the floor for `distance` grows as the shortest edge shrinks.
void Selector::update_floor(Index first_new) {
  if (!scores_are_lengths(metric_)) return;
  for (Index wedge = first_new; wedge < wedges_.size(); ++wedge)
    shortest_.emplace(-length(wedges_[wedge].h2() - wedges_[wedge].h1()), wedge);
  while (!is_edge(shortest_.top().second)) shortest_.pop();
  const double size = surroundings_.diameter, short_length = short_edge * size;
  floor_ = score_floor * size * (short_length / std::min(short_length, -shortest_.top().first));
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
        touch(i / 2);
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
  if (base_.size() <= 2) return false;
  // Near the line, p may still be far from H, beyond a corner.
  if (distance_to_segment(wedge.h1(), wedge.h2(), p) <= near_) return false;
  return !base_.is_near(p, near_);
}

}  // namespace evenlift
