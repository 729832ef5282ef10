#include <algorithm>

#include "evenlift/load_models.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

// Here q (load_models.h) is the end beyond C.
std::vector<double> shares_on_line(const Points& at) {
  double least = 0, greatest = 0;
  for (const Vec2& robot : at) {
    least = std::min(least, robot.x);
    greatest = std::max(greatest, robot.x);
  }
  std::vector<double> shares;
  for (const Vec2& robot : at) {
    const double t = robot.x;
    const double other = t > 0 ? -least : greatest;
    shares.push_back(t == 0 ? 1 : other / (std::fabs(t) + other));
  }
  return shares;
}

// The edges of H in order about C, which is inside. A share is the lever about the edge through
// which the ray leaves: C's distance from it, divided by the robot's.
class Rim {
 public:
  explicit Rim(const Points& hull) {
    const SortedIndices order = sorted_indices(hull.size(), [&](std::uint32_t i, std::uint32_t j) {
      return pseudo_angle(hull[i]) < pseudo_angle(hull[j]);
    });
    for (const std::uint32_t i : order) {
      corners_.push_back(hull[i]);
      angles_.push_back(pseudo_angle(hull[i]));
    }
  }

  double share(const Vec2& robot) const {
    const std::size_t n = corners_.size();
    const auto next = std::upper_bound(angles_.begin(), angles_.end(), pseudo_angle(-robot));
    const auto edge = static_cast<std::size_t>(next - angles_.begin()) + n - 1;
    // Near a corner, rounding may choose the neighbouring edge. The ray leaves through the edge
    // with the least share.
    return std::min(
        {share(robot, (edge - 1) % n), share(robot, edge % n), share(robot, (edge + 1) % n)});
  }

 private:
  double share(const Vec2& robot, std::size_t edge) const {
    const Vec2 &a = corners_[edge], &b = corners_[(edge + 1) % corners_.size()];
    const double of_centre = cross(b - a, -a), of_robot = cross(b - a, robot - a);
    return of_robot > of_centre ? std::max(0.0, of_centre) / of_robot : 1;
  }

  Points corners_;
  std::vector<double> angles_;
};

std::vector<double> shares_on_area(const Support& support) {
  const Rim rim(support.hull);
  std::vector<double> shares;
  for (const Vec2& robot : support.at) shares.push_back(rim.share(robot));
  return shares;
}

}  // namespace

std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight) {
  const std::optional<Support> support = find_support(robots, centre, diameter);
  if (!support) return std::nullopt;
  std::vector<double> loads =
      support->on_a_line ? shares_on_line(support->at) : shares_on_area(*support);
  for (double& load : loads) load *= weight;
  return spread_out(*support, loads, robots.size());
}

}  // namespace evenlift
