#include <algorithm>

#include "evenlift/supports.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

Misfit::Why why_misfit(WhyUnusable why, const RobotSize& robot) {
  switch (why) {
    case WhyUnusable::no_go:
    case WhyUnusable::near_no_go:
      return Misfit::Why::no_go;
    case WhyUnusable::arm:
      return Misfit::Why::arm;
    case WhyUnusable::hand:
      return Misfit::Why::hand;
    case WhyUnusable::hole:
      return Misfit::Why::hole;
    case WhyUnusable::corner:
      return robot.depth > 0 || robot.width > 0 ? Misfit::Why::hand : Misfit::Why::outside;
    case WhyUnusable::body:
    case WhyUnusable::narrow:
      break;
  }
  return Misfit::Why::outside;
}

}  // namespace

std::vector<Misfit> misfits(const Polygon& polygon, const Stands* stands,
                            const std::vector<LiftingPoint>& robots) {
  const double near = near_distance(polygon.diameter());
  std::vector<Misfit> found;
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    const LiftingPoint& robot = robots[i];
    if (stands && robot.edge != beneath)
      if (const auto why = stands->why_not(robot.edge, stands->along(robot)))
        found.push_back({i, why_misfit(*why, stands->robot()), 0});
    for (std::uint32_t other = 0; other < i; ++other)
      if (length(robot.position - robots[other].position) <= near ||
          (stands && stands->collide(robot, robots[other])))
        found.push_back({i, Misfit::Why::too_near, other});
  }
  return found;
}

std::string misfit_in_words(const Misfit& misfit) {
  switch (misfit.why) {
    case Misfit::Why::outside:
      return "outside";
    case Misfit::Why::arm:
      return "arm";
    case Misfit::Why::hand:
      return "hand";
    case Misfit::Why::hole:
      return "hole";
    case Misfit::Why::no_go:
      return "no-go";
    case Misfit::Why::too_near:
      break;
  }
  return "too near robot " + std::to_string(misfit.other + 1);
}

}  // namespace evenlift
