#include "balanced/rules.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/failures.h"
#include "evenlift/tolerance.h"

namespace evenlift::balanced {
namespace {

constexpr double usual_apart = 0.12;  // in units of R

int compare(double a, double b, double slack) { return a > b + slack ? 1 : b > a + slack ? -1 : 0; }

int compare_spreads(double a, double b) { return compare(a, b, spread_tie * std::max(a, b)); }

// 1 if the places of `a` come first.
int compare_places(const std::vector<double>& a, const std::vector<double>& b, double slack) {
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    if (const int order = compare(b[i], a[i], slack)) return order;
  return 0;
}

// Null on an error, which place() has already reported: no robot fits, or an edge does not exist.
std::shared_ptr<const Stands> room_of(const PolygonWithHoles& object, const Vec2& centre,
                                      const Settings& settings) {
  auto room = make_stands(object, centre, settings);
  return room ? *std::move(room) : nullptr;
}

// A set costs more on a winding outline, since its coverage is summed along all of it.
std::uint64_t work_on(const PolygonWithHoles& object, const EvenChords& chords,
                      const Vec2& centre) {
  constexpr std::size_t few_vertices = 1000, most_counted = 100'000, for_one = 100;
  if (object.boundary().size() <= few_vertices) return 0;
  return 1 + chords.count_about(centre, most_counted) / for_one;
}

}  // namespace

void RatedSet::begin(std::uint32_t pairs) {
  near_pairs = pairs;
  steady.reset();
  level.reset();
  hull.reset();
  coverage.reset();
  steps_of_coverage = 0;
  spread.reset();
  places.reset();
}

Rules::Rules(PolygonWithHoles object, const Vec2& centre, const Settings& settings)
    : object_(std::move(object)),
      centre_(centre),
      robots_(settings.robots),
      holds_(goal_of(settings) == Goal::hold),
      hold_(hold_requirements(object_, centre, settings)),
      survive_(static_cast<int>(settings.survive)),
      room_(room_of(object_, centre, settings)),
      outline_(object_, centre),
      stands_(outline_.stands(room_.get())),
      triples_(triples_of(settings.robots)),
      chords_(polygon(), room_.get(), outline_.edges()),
      work_of_completion_(work_on(object_, chords_, centre)),
      coarse_cover_(object_, centre),
      cover_(object_, centre),
      margins_(object_, centre, hold_) {
  const double apart = settings.apart.value_or(usual_apart * farthest_vertex(object_, centre));
  const double near = std::max(0.0, apart - near_distance(polygon().diameter()));
  near_square_ = near * near;
}

double Rules::used(const BalancedWork& work) const {
  const std::uint64_t most = is_large() ? most_steps_if_large : most_steps;
  return std::max(static_cast<double>(work.steps) / static_cast<double>(most),
                  static_cast<double>(work.completions) / most_work);
}

std::uint64_t Rules::steps_of(const RatedSet& set) const {
  const std::uint64_t robots = set.robots.size();
  constexpr std::uint64_t of_coarse_cover = 8;
  return 1 + robots / 8 + (set.hull ? robots + robots * robots / 64 + of_coarse_cover : 0) +
         (set.steady ? 40 * robots : 0) + (set.level ? (set.level->tested ? 60 : 2) * robots : 0) +
         set.steps_of_coverage;
}

std::uint32_t Rules::near_pairs(const std::vector<LiftingPoint>& robots, std::size_t number,
                                const LiftingPoint& other) const {
  std::uint32_t pairs = 0;
  for (std::size_t i = 0; i < number; ++i) {
    const Vec2 between = robots[i].position - other.position;
    pairs += dot(between, between) < near_square_ ? 1u : 0u;
  }
  return pairs;
}

bool Rules::collides(const std::vector<LiftingPoint>& robots, std::size_t number,
                     const LiftingPoint& other) const {
  for (std::size_t i = 0; room_ && i < number; ++i)
    if (room_->collide(robots[i], other)) return true;
  return false;
}

std::uint32_t Rules::near_pairs(const std::vector<LiftingPoint>& robots) const {
  std::uint32_t pairs = 0;
  for (std::size_t i = 0; i < robots.size(); ++i) pairs += near_pairs(robots, i, robots[i]);
  return pairs;
}

int Rules::steady(RatedSet& set) const {
  if (!set.steady)
    set.steady = std::min(survive_, failures_steady(positions(set.robots), centre_,
                                                    polygon().diameter(), hold_.inside));
  return *set.steady;
}

std::uint32_t Rules::level(RatedSet& set) const {
  if (!set.level) set.level = margins_.level_of(contact_points(room_.get(), set.robots));
  return set.level->level;
}

const SmallHull& Rules::hull(RatedSet& set) const {
  if (!set.hull) set.hull = small_hull(set.robots, centre_);
  return *set.hull;
}

bool Rules::covers_less(RatedSet& set, double bound) const {
  constexpr double rounding = 1 + 1e-12;
  return rounding * hull(set).area / object_.area() < bound ||
         coarse_cover_.most(hull(set)) < bound || coverage(set) < bound;
}

double Rules::coverage(RatedSet& set) const {
  if (!set.coverage) set.coverage = cover_.of(hull(set), set.steps_of_coverage);
  return *set.coverage;
}

double Rules::spread(RatedSet& set) const {
  if (!set.spread) {
    double sum = 0;
    for (const LiftingPoint& robot : set.robots) {
      const Vec2 arm = robot.position - centre_;
      sum += dot(arm, arm);
    }
    set.spread = sum;
  }
  return *set.spread;
}

// The place of a robot, or of its contact if hands lift beneath the object.
double Rules::place(const LiftingPoint& robot) const {
  return outline_.place(room_ ? LiftingPoint{room_->contact(robot), robot.edge} : robot);
}

const std::vector<double>& Rules::places(RatedSet& set) const {
  if (!set.places) {
    std::vector<double> places;
    for (const LiftingPoint& robot : set.robots) places.push_back(place(robot));
    std::sort(places.begin(), places.end());
    set.places = std::move(places);
  }
  return *set.places;
}

// Whether `a` covers less and no earlier key can decide for it.
bool Rules::surely_loses_by_coverage(RatedSet& a, RatedSet& b) const {
  if (survive_ > 0 && steady(b) < survive_) return false;
  if (holds_ && level(b) < best_level) return false;
  return covers_less(a, coverage(b) - coverage_tie);
}

Rules::Decision Rules::decide(RatedSet& a, RatedSet& b) const {
  const auto sign = [](auto x, auto y) { return x > y ? 1 : x < y ? -1 : 0; };
  if (const int order = sign(b.near_pairs, a.near_pairs)) return {order, BalancedKey::near_pairs};
  if (survive_ > 0)
    if (const int order = sign(steady(a), steady(b))) return {order, BalancedKey::steady};
  if (holds_)
    if (const int order = sign(level(a), level(b))) return {order, BalancedKey::level};
  if (const int order = compare(coverage(a), coverage(b), coverage_tie))
    return {order, BalancedKey::coverage};
  if (const int order = compare_spreads(spread(a), spread(b))) return {order, BalancedKey::spread};
  return {compare_places(places(a), places(b), tau * outline_.length()), BalancedKey::places};
}

bool Rules::better(RatedSet& a, RatedSet& b) const {
  if (a.near_pairs == b.near_pairs && surely_loses_by_coverage(a, b)) return false;
  return decide(a, b).order > 0;
}

std::optional<BalancedKey> Rules::decided_by(RatedSet& a, RatedSet& b) const {
  const Decision decision = decide(a, b);
  return decision.order == 0 ? std::nullopt : std::optional(decision.key);
}

RatedSet Rules::rated(const std::vector<LiftingPoint>& robots) const {
  RatedSet set;
  set.robots = robots;
  set.begin(near_pairs(robots));
  return set;
}

BalancedKeys Rules::keys(RatedSet& set) const {
  return {set.near_pairs,
          survive_ > 0 ? steady(set) : 0,
          holds_ ? level(set) : 0,
          coverage(set),
          spread(set),
          places(set)};
}

RatedSet Rules::in_order(const RatedSet& set) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < set.robots.size(); ++i) order.emplace_back(place(set.robots[i]), i);
  std::sort(order.begin(), order.end());
  RatedSet ordered = set;
  for (std::size_t i = 0; i < order.size(); ++i) ordered.robots[i] = set.robots[order[i].second];
  return ordered;
}

}  // namespace evenlift::balanced
