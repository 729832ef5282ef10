#include "balanced/usable_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "evenlift/tolerance.h"

namespace evenlift::balanced {
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
  std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    return a.ahead * b.across > b.ahead * a.across;
  });
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
