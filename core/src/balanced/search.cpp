#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "balanced/search.h"
#include "evenlift/balanced.h"
#include "evenlift/balanced_history.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift::balanced {
namespace {

std::uint64_t most_steps_of_start(const Rules& rules) {
  return rules.is_large() ? most_start_steps_if_large : most_start_steps;
}

// The trial points from which S_4 begins.
enum class Begin { as_usual, at_every_stand };

std::optional<StartSet> next_set(const Rules& rules, const StartSets& sets, Begin begin,
                                 std::uint64_t& steps) {
  const std::size_t number = sets.size();
  const std::uint64_t most = most_steps_of_start(rules);
  Best best(rules, most - std::min(most, steps));
  if (sets[number - 2]) best.offer_two_more(sets[number - 2]->set.robots);
  if (number >= 3 && sets[number - 3]) best.offer_three_more(sets[number - 3]->set.robots);
  const bool at_stands = rules.robots() == 4 || begin == Begin::at_every_stand;
  if (number == 4 && (at_stands || !best.set()))
    for (const LiftingPoint& stand : rules.stands()) best.offer_three_more({stand});
  steps += best.steps();
  if (!best.set()) return std::nullopt;
  const std::vector<LiftingPoint>& robots = best.set()->robots;
  const auto kept = robots.begin() + static_cast<std::ptrdiff_t>(best.kept());
  return StartSet{rules.in_order(*best.set()), {robots.begin(), kept}, {kept, robots.end()}};
}

StartSets chain(const Rules& rules, Begin begin, std::uint64_t& steps) {
  StartSets sets{StartSet{}, std::nullopt};
  while (sets.size() <= rules.robots()) sets.push_back(next_set(rules, sets, begin, steps));
  return sets;
}

// The result of the swaps from a start, whose steps add to `work`.
RatedSet end_of(const Rules& rules, const RatedSet& start, BalancedWork& work) {
  BalancedSearch search;
  search.robots = rules.in_order(start).robots;
  search.finished = rules.robots() < 3;
  search.restarted = true;
  search.work.steps = work.steps;
  const BalancedSearch end = finish_search(rules, std::move(search));
  work.steps = end.work.steps;
  return rules.rated(end.robots);
}

StartSet whole(const Rules& rules, const RatedSet& set) {
  const RatedSet ordered = rules.in_order(set);
  return {ordered, {}, ordered.robots, true};
}

std::optional<StartSets> start_that_leads_farther(const Rules& rules, RatedSet now,
                                                  BalancedWork& work) {
  std::optional<StartSets> start;
  for (const RatedSet& set : usable_sets(rules, most_starts)) {
    RatedSet end = end_of(rules, set, work);
    if (!rules.better(end, now)) continue;
    now = std::move(end);
    start = StartSets{whole(rules, set)};
  }
  return start;
}

}  // namespace

StartSets start_sets(const Rules& rules, bool* cut_short) {
  std::uint64_t steps = 0;
  StartSets sets = chain(rules, Begin::as_usual, steps);
  if (cut_short) *cut_short = steps >= most_steps_of_start(rules);
  if (rules.room() && !sets.back())
    for (const RatedSet& set : usable_sets(rules, 1)) sets.back() = whole(rules, set);
  return sets;
}

std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& robots,
                                      BalancedWork& work) {
  RatedSet now = rules.rated(robots);
  if (rules.room()) return start_that_leads_farther(rules, std::move(now), work);
  if (rules.robots() <= 4 || !rules.misses_hold(now)) return std::nullopt;
  std::uint64_t steps = 0;
  StartSets sets = chain(rules, Begin::at_every_stand, steps);
  work.steps += steps;
  if (!sets.back() || !rules.holds_better(sets.back()->set, now)) return std::nullopt;
  return sets;
}

namespace {

// A usable interval of an edge, by distances t along the edge. The lifting point of t is at(t),
// relative to C.
struct Interval {
  std::uint32_t edge = 0;
  double from = 0, to = 0;
  Vec2 start, along;
  std::uint32_t most = 0;  // the number of robots that fit beside each other

  Vec2 at(double t) const { return start + t * along; }
};

// The number of robots on an interval, and the possible places of their middle.
struct Group {
  const Interval* interval;
  std::uint32_t robots;
  double middle, half;  // from middle - half to middle + half
  double share = 0;     // the middle is at `middle + share * half`; -1 .. 1
};

// can_balance() bounds sums in these directions before settle() solves them.
constexpr std::array<std::array<double, 2>, 16> compass{{{1, 0},
                                                         {2, 1},
                                                         {1, 1},
                                                         {1, 2},
                                                         {0, 1},
                                                         {-1, 2},
                                                         {-1, 1},
                                                         {-2, 1},
                                                         {-1, 0},
                                                         {-2, -1},
                                                         {-1, -1},
                                                         {-1, -2},
                                                         {0, -1},
                                                         {1, -2},
                                                         {1, -1},
                                                         {2, -1}}};
using Reach = std::array<double, compass.size()>;

Reach reach_of(const Interval& interval) {
  Reach reach;
  const Vec2 first = interval.at(interval.from), last = interval.at(interval.to);
  for (std::size_t i = 0; i < compass.size(); ++i) {
    const Vec2 u(compass[i][0], compass[i][1]);
    reach[i] = std::max(dot(u, first), dot(u, last));
  }
  return reach;
}

// Finds shares that make the sum of all positions 0: those that move it farthest straight towards
// 0, scaled back (a knapsack with divisible items). Returns false if it cannot reach 0.
bool settle(std::vector<Group>& groups, double near) {
  Vec2 missing;
  for (const Group& group : groups) missing -= group.robots * group.interval->at(group.middle);
  const double way = length(missing);
  if (way <= near) return true;
  const Vec2 towards = missing / way;
  struct Item {
    Group* group;
    double sign, across, ahead;
  };
  std::vector<Item> items;
  double behind = 0;  // the sum of `across`; with all shares at -1, the balance is -behind
  for (Group& group : groups) {
    const Vec2 whole = group.robots * group.half * group.interval->along;
    double across = cross(towards, whole), ahead = dot(towards, whole);
    const double sign = across < 0 || (across == 0 && ahead < 0) ? -1 : 1;
    across *= sign;
    ahead *= sign;
    behind += across;
    items.push_back({&group, sign, across, ahead});
  }
  // The steepest come first: they get the share 1 until the others, with -1, balance them.
  sort_items(items,
             [](const Item& a, const Item& b) { return a.ahead * b.across > b.ahead * a.across; });
  double balance = -behind, reached = 0;
  std::vector<double> shares;
  for (const Item& item : items) {
    double share = -1;
    if (item.across == 0)
      share = 1;
    else if (balance < 0)
      share = std::min(1.0, -1 - balance / item.across);
    balance += (share + 1) * item.across;
    reached += share * item.ahead;
    shares.push_back(share);
  }
  if (reached < way - near) return false;
  const double scale = std::min(1.0, way / reached);
  for (std::size_t i = 0; i < items.size(); ++i)
    items[i].group->share = items[i].sign * shares[i] * scale;
  return true;
}

class UsableSets {
 public:
  UsableSets(const Rules& rules, std::size_t most)
      : rules_(rules),
        most_(most),
        near_(near_distance(rules.polygon().diameter())),
        spacing_(spacing_of(rules.room()->robot())) {
    for (const std::uint32_t edge : rules.outline().edges()) add_intervals(edge);
    reach_behind_.resize(intervals_.size() + 1);
    reach_behind_.back().fill(0);
    for (std::size_t i = intervals_.size(); i-- > 0;) {
      const Reach reach = reach_of(intervals_[i]);
      for (std::size_t u = 0; u < compass.size(); ++u)
        reach_behind_[i][u] =
            i + 1 == intervals_.size() ? reach[u] : std::max(reach[u], reach_behind_[i + 1][u]);
    }
  }

  std::vector<RatedSet> find() && {
    Reach none;
    none.fill(0);
    choose(0, rules_.robots(), none);
    return std::move(best_);
  }

 private:
  static double spacing_of(const RobotSize& robot) {
    return std::max(2 * robot.radius + robot.gap, robot.width);
  }

  void add_intervals(std::uint32_t edge) {
    const Polygon& polygon = rules_.polygon();
    const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
    const double size = length(q - p);
    for (const Stretch& stretch : rules_.room()->usable(edge)) {
      Interval interval{
          edge,           stretch.from,
          stretch.to,     rules_.room()->lifting_point({p, edge}).position - rules_.centre(),
          (q - p) / size, rules_.robots()};
      const double room = (stretch.to - stretch.from + near_) / spacing_;
      if (spacing_ > 0 && room < rules_.robots())
        interval.most = static_cast<std::uint32_t>(room) + 1;
      intervals_.push_back(interval);
    }
  }

  // Distributes `left` robots over the intervals from `from` on. `reach` bounds the sum of the
  // robots so far in each direction of the compass. The stack grows with robots only, not with
  // intervals that stay without one.
  void choose(std::size_t from, std::uint32_t left, const Reach& reach) {
    if (left == 0) return settle_and_keep();
    for (; from < intervals_.size(); ++from) {
      if (++nodes_ > most_nodes || !can_balance(from, left, reach)) return;
      const Interval& interval = intervals_[from];
      const Reach of_one = reach_of(interval);
      for (std::uint32_t robots = std::min(left, interval.most); robots > 0; --robots) {
        Reach sum = reach;
        for (std::size_t u = 0; u < compass.size(); ++u) sum[u] += robots * of_one[u];
        chosen_.push_back({from, robots});
        choose(from + 1, left - robots, sum);
        chosen_.pop_back();
      }
    }
  }

  bool can_balance(std::size_t from, std::uint32_t left, const Reach& reach) const {
    for (std::size_t u = 0; u < compass.size(); ++u)
      if (reach[u] + left * reach_behind_[from][u] < -near_ * left) return false;
    return true;
  }

  void settle_and_keep() {
    std::vector<Group> groups;
    for (const auto& [number, robots] : chosen_) {
      const Interval& interval = intervals_[number];
      const double half_width = spacing_ * (robots - 1) / 2;
      groups.push_back({&interval, robots, (interval.from + interval.to) / 2,
                        std::max(0.0, (interval.to - interval.from) / 2 - half_width)});
    }
    if (!settle(groups, near_)) return;
    for (const double width : {0.0, 0.5, 1.0}) keep(robots_of(groups, width));
  }

  // At width 0 as close together as possible, at width 1 as far apart.
  std::vector<LiftingPoint> robots_of(const std::vector<Group>& groups, double width) const {
    std::vector<LiftingPoint> robots;
    for (const Group& group : groups) {
      const Interval& interval = *group.interval;
      const double middle = group.middle + group.share * group.half;
      const double room = std::min(middle - interval.from, interval.to - middle);
      const double least = spacing_ * (group.robots - 1) / 2;
      const double half = std::max(least, least + width * (room - least));
      for (std::uint32_t i = 0; i < group.robots; ++i) {
        const double part = group.robots > 1 ? 2.0 * i / (group.robots - 1) - 1 : 0;
        const double t = std::clamp(middle + part * half, interval.from, interval.to);
        robots.push_back({rules_.centre() + interval.at(t), interval.edge});
      }
    }
    return robots;
  }

  void keep(const std::vector<LiftingPoint>& robots) {
    for (std::size_t i = 0; i < robots.size(); ++i)
      if (!rules_.room()->can_use(robots[i]) || rules_.collides(robots, i, robots[i])) return;
    RatedSet set = rules_.rated(robots);
    auto at = best_.end();
    while (at != best_.begin() && rules_.better(set, *(at - 1))) --at;
    if (static_cast<std::size_t>(at - best_.begin()) >= most_) return;
    best_.insert(at, std::move(set));
    if (best_.size() > most_) best_.pop_back();
  }

  const Rules& rules_;
  std::size_t most_;
  double near_, spacing_;
  std::vector<Interval> intervals_;
  std::vector<Reach> reach_behind_;  // the reach of one robot on this interval or a later one
  std::vector<std::pair<std::size_t, std::uint32_t>> chosen_;  // intervals, and their robots
  std::size_t nodes_ = 0;
  std::vector<RatedSet> best_;
};

}  // namespace

std::vector<RatedSet> usable_sets(const Rules& rules, std::size_t most) {
  if (!rules.room()) return {};
  return UsableSets(rules, most).find();
}

}  // namespace evenlift::balanced

namespace evenlift {

namespace {

using balanced::Best;
using balanced::RatedSet;
using balanced::Rules;

std::size_t completions_of_start(const Rules& rules) {
  const std::size_t stands = rules.stands().size(), robots = rules.robots();
  return stands * (robots - 1) + (robots == 4 ? stands * stands : 0);
}

// A step takes about a microsecond. A candidate costs one step, and more on a winding outline,
// since the coverage of its set is summed along it.
std::size_t steps_of_completion(const Rules& rules) {
  constexpr std::size_t most_candidates = 2'000, winding = 50;
  const std::size_t candidates = rules.chords().count_about(rules.centre(), most_candidates);
  return candidates * (1 + candidates / winding);
}

BalancedSearch restarted(const Rules& rules, BalancedSearch search) {
  search.restarted = true;
  search.work_before_restart = search.work;
  const auto second = balanced::second_start(rules, search.robots, search.work);
  const bool spent = rules.used(search.work) >= 1;
  search.cut_short |= spent;
  if (!second || spent) return search;
  search.robots = second->back()->set.robots;
  search.round = 0;
  search.finished = rules.robots() < 3;
  return search;
}

BalancedSearch ended(const Rules& rules, BalancedSearch search, std::uint64_t steps) {
  search.work.steps += steps;
  search.work.completions += rules.stands().size() * rules.work_of_completion();
  search.finished = rules.used(search.work) >= 1;
  search.cut_short |= search.finished;
  if (search.finished || search.next < rules.triples().size()) return search;
  ++search.round;
  search.finished = !search.changed || search.round == most_rounds;
  search.next = 0;
  search.changed = false;
  if (!search.finished || search.restarted) return search;
  return restarted(rules, std::move(search));
}

}  // namespace

BalancedProblem::BalancedProblem(PolygonWithHoles object, const Vec2& centre,
                                 const Settings& settings)
    : rules_(std::make_shared<const Rules>(std::move(object), centre, settings)) {}

BalancedKeys balanced_keys(const BalancedProblem& problem,
                           const std::vector<LiftingPoint>& robots) {
  RatedSet set = problem.rules().rated(robots);
  return problem.rules().keys(set);
}

bool is_better(const BalancedProblem& problem, const std::vector<LiftingPoint>& a,
               const std::vector<LiftingPoint>& b) {
  const Rules& rules = problem.rules();
  RatedSet first = rules.rated(a), second = rules.rated(b);
  return rules.better(first, second);
}

std::optional<BalancedSearch> start_balanced(const BalancedProblem& problem, bool* cut_short) {
  const Rules& rules = problem.rules();
  BalancedSearch search;
  auto sets = balanced::start_sets(rules, &search.cut_short);
  if (cut_short) *cut_short = search.cut_short;
  if (!sets.back()) return std::nullopt;
  search.robots = std::move(sets.back()->set.robots);
  search.finished = rules.robots() < 3;
  return search;
}

double work_used(const BalancedProblem& problem, const BalancedSearch& search) {
  return problem.rules().used(search.work);
}

bool is_quick_to_start(const BalancedProblem& problem) {
  return completions_of_start(problem.rules()) * steps_of_completion(problem.rules()) <= 100'000;
}

bool is_quick_to_finish(const BalancedProblem& problem) {
  const Rules& rules = problem.rules();
  constexpr std::size_t usual_rounds = 3;
  // Robots with a size, or with no-go parts, restart from several starts.
  const std::size_t searches = rules.room() ? 2 + balanced::most_starts : 1;
  const std::size_t completions = completions_of_start(rules) + searches * usual_rounds *
                                                                    rules.triples().size() *
                                                                    rules.stands().size();
  return completions * steps_of_completion(rules) <= 500'000;
}

namespace balanced {

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search) {
  if (search.finished) return {std::move(search), std::nullopt};
  const std::vector<Triple>& triples = rules.triples();
  const Triple& triple = triples[search.next++];
  Best best(rules);
  best.offer(rules.rated(search.robots));
  best.offer_three_more(others(search.robots, triple));
  std::optional<BalancedSwap> swap;
  if (best.completed()) {
    swap.emplace();
    swap->numbers = triple;
    // The three new robots are the last.
    const std::vector<LiftingPoint>& robots = best.set()->robots;
    for (std::size_t i = 0; i < triple.size(); ++i) {
      swap->from[i] = search.robots[triple[i]];
      swap->to[i] = robots[robots.size() - triple.size() + i];
    }
    search.robots = rules.in_order(*best.set()).robots;
    search.changed = true;
  }
  return {ended(rules, std::move(search), best.steps()), swap};
}

BalancedSearch finish_search(const Rules& rules, BalancedSearch search) {
  while (!search.finished) search = try_next_triple(rules, std::move(search)).search;
  return search;
}

}  // namespace balanced

BalancedStep try_next_triple(const BalancedProblem& problem, BalancedSearch search) {
  return balanced::try_next_triple(problem.rules(), std::move(search));
}

BalancedSearch finish_search(const BalancedProblem& problem, BalancedSearch search) {
  return balanced::finish_search(problem.rules(), std::move(search));
}

}  // namespace evenlift
