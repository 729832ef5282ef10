#include "balanced/completions.h"

#include <utility>

#include "evenlift/predicates.h"

namespace evenlift::balanced {
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
