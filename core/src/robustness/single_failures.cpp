#include <algorithm>

#include "evenlift/closure.h"
#include "evenlift/failures.h"
#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "evenlift/stability.h"
#include "evenlift/uncertainty.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

// All robots, and values that do not depend on which one fails.
class Crew {
 public:
  Crew(const PolygonWithHoles& object, const Vec2& centre, double weight,
       const std::vector<Team>& teams, double inside, const Disturbance& disturbance)
      : object_(object),
        centre_(centre),
        weight_(weight),
        inside_(inside),
        disturbance_(after_failure(disturbance, count_robots(teams))),
        teams_(teams),
        contacts_(contacts(object, lifting_points(teams))),
        positions_(positions(lifting_points(teams))) {
    const Points hull = convex_hull(positions_, near());
    if (hull.size() >= 3) coverage_.emplace(object, hull);
  }

  std::optional<RestOfRobots> without(std::size_t robot) const;

 private:
  double near() const {
    return near_distance(known_size(positions_, centre_, object_.outline().diameter()));
  }

  Points positions_without(std::size_t robot) const {
    Points rest = positions_;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(robot));
    return rest;
  }

  std::vector<Contact> contacts_without(std::size_t robot) const {
    std::vector<Contact> rest;
    for (const Contact& contact : contacts_)
      if (contact.point != robot) rest.push_back(contact);
    return rest;
  }

  // The other teams carry the weight in proportion to their former loads.
  std::optional<double> greatest_by_plan(std::size_t robot) const {
    const std::size_t failed = find_robot(teams_, robot).team;
    double greatest = 0, carried = 0;
    for (std::size_t t = 0; t < teams_.size(); ++t) {
      if (t == failed) continue;
      for (const Robot& other : teams_[t].robots) {
        greatest = std::max(greatest, other.load / weight_);
        carried += other.load / weight_;
      }
    }
    if (teams_.size() < 2) return std::nullopt;
    return weight_ * (greatest / carried);
  }

  const PolygonWithHoles& object_;
  Vec2 centre_;
  double weight_, inside_;
  Disturbance disturbance_;
  const std::vector<Team>& teams_;
  std::vector<Contact> contacts_;
  Points positions_;
  std::optional<CoverageWithin> coverage_;  // nullopt if the lifting base has no area
};

std::optional<RestOfRobots> Crew::without(std::size_t robot) const {
  const Points others = positions_without(robot);
  const double diameter = object_.outline().diameter();
  const auto springs = spring_loads(others, centre_, diameter, weight_);
  const auto best = best_load(others, centre_, diameter, weight_);
  if (!springs || !best) return std::nullopt;
  const Points hull = convex_hull(others, near());
  const Hold hold = analyse_hold(object_, centre_, contacts_without(robot));
  RestOfRobots rest;
  rest.tipping_distance = tipping_distance(hull, centre_, diameter);
  rest.steady = rest.tipping_distance > 0;
  rest.clear = rest.steady && rest.tipping_distance >= inside_ - near();
  rest.coverage = coverage_ ? coverage_->of(hull) : 0;
  rest.form_closure = hold.form_closure;
  rest.margin = hold.margin;
  rest.greatest_by_plan = greatest_by_plan(robot);
  rest.greatest_by_springs = *std::max_element(springs->loads.begin(), springs->loads.end());
  rest.stays =
      effect_on(others, centre_, diameter, disturbance_).reach <= rest.tipping_distance + near();
  rest.least_greatest = *best;
  const auto with_failed = [&](std::vector<double> loads) {
    loads.insert(loads.begin() + static_cast<std::ptrdiff_t>(robot), 0.0);
    return loads;
  };
  if (rest.stays) {
    rest.ends =
        with_failed(disturbance_.any() ? greatest_loads(others, centre_, diameter, weight_,
                                                        springs->loads, *springs, disturbance_)
                                       : springs->loads);
    rest.greatest_end = *std::max_element(rest.ends.begin(), rest.ends.end());
  }
  if (positions_.size() <= most_robots_listed) rest.springs = with_failed(springs->loads);
  return rest;
}

}  // namespace

std::vector<std::optional<RestOfRobots>> single_failures(const PolygonWithHoles& object,
                                                         const Vec2& centre, double weight,
                                                         const std::vector<Team>& teams,
                                                         double inside,
                                                         const Disturbance& disturbance) {
  const Crew crew(object, centre, weight, teams, inside, disturbance);
  std::vector<std::optional<RestOfRobots>> failures;
  for (std::size_t robot = 0; robot < count_robots(teams); ++robot)
    failures.push_back(crew.without(robot));
  return failures;
}

std::optional<RestOfRobots> single_failure(const PolygonWithHoles& object, const Vec2& centre,
                                           double weight, const std::vector<Team>& teams,
                                           std::size_t robot, double inside,
                                           const Disturbance& disturbance) {
  return Crew(object, centre, weight, teams, inside, disturbance).without(robot);
}

}  // namespace evenlift
