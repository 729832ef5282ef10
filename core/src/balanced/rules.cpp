#include "balanced/search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/failures.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift::balanced {
namespace {

constexpr std::size_t many_vertices = 1000;
constexpr std::uint32_t usual_stands = 64, stands_of_many_vertices = 16;

// v*: among the vertices farthest from C within tolerance, the leftmost, then the lowest.
std::uint32_t first_vertex(const Polygon& polygon, const Vec2& centre) {
  const double farthest = farthest_vertex(polygon, centre);
  const double near = near_distance(polygon.diameter());
  std::optional<std::uint32_t> first;
  for (std::uint32_t v = 0; v < polygon.size(); ++v) {
    if (length(polygon.vertex(v) - centre) < farthest - near) continue;
    if (!first || lexicographically_before(polygon.vertex(v), polygon.vertex(*first))) first = v;
  }
  return *first;
}

}  // namespace

Outline::Outline(const Polygon& polygon, const Vec2& centre)
    : polygon_(polygon), steps_(polygon.size()) {
  std::uint32_t here = first_vertex(polygon, centre);
  starts_.push_back(0);
  for (std::uint32_t step = 0; step < polygon.size(); ++step) {
    const auto next = static_cast<std::uint32_t>(
        polygon.counter_clockwise() ? polygon.next(here) : polygon.previous(here));
    vertices_.push_back(here);
    steps_[polygon.counter_clockwise() ? here : next] = step;
    starts_.push_back(starts_.back() +
                      evenlift::length(polygon.vertex(next) - polygon.vertex(here)));
    here = next;
  }
}

// In a clockwise list, a step runs against the edge that ends at its vertex.
std::uint32_t Outline::edge_of_step(std::size_t step) const {
  const std::uint32_t vertex = vertices_[step];
  return polygon_.counter_clockwise() ? vertex
                                      : static_cast<std::uint32_t>(polygon_.previous(vertex));
}

double Outline::place(const LiftingPoint& point) const {
  const std::uint32_t step = steps_[point.edge];
  const double place =
      starts_[step] + evenlift::length(point.position - polygon_.vertex(vertices_[step]));
  return place < length() - tau * length() ? place : 0;
}

std::vector<LiftingPoint> Outline::even_stands(std::uint32_t number) const {
  std::vector<LiftingPoint> stands;
  std::size_t step = 0;
  for (std::uint32_t j = 0; j < number; ++j) {
    const double place = (j + 0.5) * length() / number;
    while (step + 1 < vertices_.size() && starts_[step + 1] <= place) ++step;
    const std::uint32_t from = vertices_[step],
                        to = vertices_[step + 1 < vertices_.size() ? step + 1 : 0];
    const Vec2 &a = polygon_.vertex(from), &b = polygon_.vertex(to);
    const double part = (place - starts_[step]) / (starts_[step + 1] - starts_[step]);
    stands.push_back({a + part * (b - a), polygon_.counter_clockwise() ? from : to});
  }
  return stands;
}

std::vector<LiftingPoint> Outline::reflex_stands(std::uint32_t most) const {
  std::vector<LiftingPoint> stands;
  for (const std::uint32_t v : vertices_) {
    if (polygon_.turn(v) != Turn::reflex) continue;
    if (stands.size() == most) return {};
    stands.push_back({polygon_.vertex(v), v});
  }
  return stands;
}

std::vector<LiftingPoint> Outline::usable_stands(std::uint32_t number, const Stands& room) const {
  double total = 0;
  for (std::uint32_t edge = 0; edge < vertices_.size(); ++edge)
    for (const Stretch& stretch : room.usable(edge)) total += stretch.to - stretch.from;
  std::vector<LiftingPoint> stands;
  double before = 0;
  for (std::size_t step = 0; step < vertices_.size(); ++step) {
    const std::uint32_t edge = edge_of_step(step);
    const Vec2 &p = polygon_.edge_start(edge), &q = polygon_.edge_end(edge);
    const double size = evenlift::length(q - p);
    std::vector<Stretch> stretches(room.usable(edge).begin(), room.usable(edge).end());
    if (!polygon_.counter_clockwise()) std::reverse(stretches.begin(), stretches.end());
    for (const Stretch& stretch : stretches) {
      const double part = stretch.to - stretch.from;
      while (stands.size() < number) {
        const double way = (static_cast<double>(stands.size()) + 0.5) * total / number - before;
        if (way > part) break;
        const double t = polygon_.counter_clockwise() ? stretch.from + way : stretch.to - way;
        stands.push_back(room.lifting_point({p + (t / size) * (q - p), edge}));
      }
      before += part;
    }
  }
  return stands;
}

std::vector<std::uint32_t> Outline::edges() const {
  std::vector<std::uint32_t> edges;
  edges.reserve(vertices_.size());
  for (std::size_t step = 0; step < vertices_.size(); ++step) edges.push_back(edge_of_step(step));
  return edges;
}

std::vector<LiftingPoint> Outline::interval_stands(std::uint32_t most, const Stands& room) const {
  std::vector<LiftingPoint> stands;
  for (const std::uint32_t edge : edges()) {
    const Vec2 &p = polygon_.edge_start(edge), &q = polygon_.edge_end(edge);
    const double size = evenlift::length(q - p);
    std::vector<Stretch> stretches(room.usable(edge).begin(), room.usable(edge).end());
    if (!polygon_.counter_clockwise())
      for (Stretch& stretch : stretches) std::swap(stretch.from, stretch.to);
    if (!polygon_.counter_clockwise()) std::reverse(stretches.begin(), stretches.end());
    for (const Stretch& stretch : stretches) {
      if (stands.size() == 3 * std::size_t{most}) return {};
      for (const double t : {stretch.from, (stretch.from + stretch.to) / 2, stretch.to})
        stands.push_back(room.lifting_point({p + (t / size) * (q - p), edge}));
    }
  }
  return stands;
}

std::vector<LiftingPoint> Outline::stands(const Stands* room) const {
  const std::uint32_t number =
      vertices_.size() > many_vertices ? stands_of_many_vertices : usual_stands;
  std::vector<LiftingPoint> stands = room ? usable_stands(number, *room) : even_stands(number);
  const std::vector<LiftingPoint> more =
      room ? interval_stands(number, *room) : reflex_stands(number);
  stands.insert(stands.end(), more.begin(), more.end());
  return stands;
}

namespace {

// How many of the three pairs must be neighbours along the outline. Beyond 24 robots, two pairs
// cost 1 percentage point more coverage than one but take a twentieth of the time.
std::uint32_t neighbours_needed(std::uint32_t robots) {
  return robots <= 12 ? 0 : robots <= 24 ? 1 : 2;
}

}  // namespace

std::vector<Triple> triples_of(std::uint32_t robots) {
  const std::uint32_t needed = neighbours_needed(robots);
  const auto one_if = [](bool neighbours) { return neighbours ? 1u : 0u; };
  std::vector<Triple> triples;
  for (std::uint32_t i = 0; i < robots; ++i)
    for (std::uint32_t j = i + 1; j < robots; ++j)
      for (std::uint32_t k = j + 1; k < robots; ++k)
        if (one_if(j == i + 1) + one_if(k == j + 1) + one_if(k == i + robots - 1) >= needed)
          triples.push_back({i, j, k});
  return triples;
}

std::vector<LiftingPoint> others(const std::vector<LiftingPoint>& robots, const Triple& triple) {
  std::vector<LiftingPoint> others;
  others.reserve(robots.size());
  for (std::uint32_t i = 0; i < robots.size(); ++i)
    if (i != triple[0] && i != triple[1] && i != triple[2]) others.push_back(robots[i]);
  return others;
}

namespace {

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

namespace {

bool strictly_inside(const Points& hull, const Vec2& p) {
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (orient(hull[i], hull[i + 1 == hull.size() ? 0 : i + 1], p) <= 0) return false;
  return true;
}

}  // namespace

Vec2 middle_of_two_more(const std::vector<LiftingPoint>& robots, const Vec2& centre) {
  Vec2 sum = static_cast<double>(robots.size() + 2) * centre;
  for (const LiftingPoint& robot : robots) sum -= robot.position;
  return sum / 2;
}

std::vector<Candidate> pairs_to_complete(const Rules& rules,
                                         const std::vector<LiftingPoint>& robots,
                                         std::uint64_t& steps) {
  const Vec2 middle = middle_of_two_more(robots, rules.centre());
  if (!strictly_inside(rules.polygon().hull(), middle)) return {};
  std::uint64_t compared = 0;
  std::vector<Candidate> pairs = rules.chords().some_about(middle, compared);
  steps += compared / 4 + 10 * pairs.size();
  return pairs;
}

std::vector<Candidate> all_pairs_to_complete(const Rules& rules,
                                             const std::vector<LiftingPoint>& robots) {
  const Vec2 middle = middle_of_two_more(robots, rules.centre());
  if (!strictly_inside(rules.polygon().hull(), middle)) return {};
  return rules.chords().about(middle);
}

void Best::offer_two_more(const std::vector<LiftingPoint>& robots) {
  complete(robots, 0, rules_.near_pairs(robots));
}

void Best::offer_three_more(const std::vector<LiftingPoint>& robots) {
  const std::uint32_t near_pairs = rules_.near_pairs(robots);
  std::vector<LiftingPoint> all = robots;
  all.emplace_back();
  for (const LiftingPoint& stand : rules_.stands()) {
    if (steps_ >= most_steps_ && (set_ || rules_.room())) return;
    all.back() = stand;
    if (rules_.collides(robots, robots.size(), stand)) continue;
    complete(all, 1, near_pairs + rules_.near_pairs(robots, robots.size(), stand));
  }
}

void Best::offer_three_more(const std::vector<LiftingPoint>& robots, const LiftingPoint& place) {
  std::vector<LiftingPoint> all = robots;
  all.push_back(place);
  if (rules_.collides(robots, robots.size(), place)) return;
  complete(all, 1, rules_.near_pairs(all));
}

void Best::complete(const std::vector<LiftingPoint>& robots, std::size_t added,
                    std::uint32_t near_pairs) {
  // Adding robots never reduces the number of near pairs.
  ++steps_;
  if (set_ && near_pairs > set_->near_pairs) return;
  for (const Candidate& candidate : pairs_to_complete(rules_, robots, steps_)) {
    const LiftingPoint &r1 = candidate.chord.r1, &r2 = candidate.chord.r2;
    if (rules_.room()) steps_ += 2 * robots.size();
    // The two do not collide with each other.
    if (rules_.collides(robots, robots.size(), r1) || rules_.collides(robots, robots.size(), r2))
      continue;
    offered_.robots = robots;
    offered_.robots.push_back(r1);
    const std::uint32_t pairs = near_pairs + rules_.near_pairs(robots, robots.size(), r1) +
                                rules_.near_pairs(offered_.robots, offered_.robots.size(), r2);
    offered_.robots.push_back(r2);
    offered_.begin(pairs);
    const bool loses = set_ && !rules_.better(offered_, *set_);
    steps_ += rules_.steps_of(offered_);
    if (loses) continue;
    set_ = std::exchange(offered_, {});
    completed_ = true;
    kept_ = robots.size() - added;
  }
}

}  // namespace evenlift::balanced
