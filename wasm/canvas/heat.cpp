#include "canvas/heat.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace evenlift::view {
namespace {

// A side of H: how far beyond it a point lies, in units of how far C lies within.
struct Side {
  Vec2 a, along;
  double within;
  double beyond(const Vec2& p) const { return -cross(along, p - a) / within; }
};

// A base of thousands of corners is as good as round: its sides need not all be looked at.
constexpr std::size_t most_sides = 1000;

// Those sides that some vertex lies beyond: the others cut nothing off.
std::vector<Side> cutting_sides(const Placement& placement) {
  std::vector<Side> sides;
  const Points& hull = placement.lifting_base;
  const std::size_t step = (hull.size() + most_sides - 1) / most_sides;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const Vec2 along = hull[i + 1 == hull.size() ? 0 : i + 1] - hull[i];
    const Side side{hull[i], along, cross(along, placement.centre_of_mass - hull[i])};
    if (!(side.within > 0)) continue;
    const bool cuts = std::any_of(placement.vertices.begin(), placement.vertices.end(),
                                  [&](const Vec2& p) { return side.beyond(p) > 0; });
    if (cuts) sides.push_back(side);
  }
  return sides;
}

// What of a convex polygon lies at most `most` beyond the side.
void cut(std::vector<Vec2>& area, const Side& side, double most, std::vector<Vec2>& kept) {
  kept.clear();
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Vec2 &a = area[i], &b = area[i + 1 == area.size() ? 0 : i + 1];
    const double at_a = most - side.beyond(a), at_b = most - side.beyond(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  area.swap(kept);
}

// A rectangle that holds all of the polygon, counter-clockwise.
Points box_around(const Points& polygon) {
  Vec2 low = polygon[0], high = low;
  for (const Vec2& p : polygon) {
    low = {std::min(low.x(), p.x()), std::min(low.y(), p.y())};
    high = {std::max(high.x(), p.x()), std::max(high.y(), p.y())};
  }
  const Vec2 more = high - low;
  low -= more;
  high += more;
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

HeatBand band(const Placement& placement, const std::vector<std::uint32_t>& triangles,
              const std::vector<Side>& sides, double share) {
  HeatBand result{share, {}, {}};
  const double most = share > 0 ? 1 / share : std::numeric_limits<double>::infinity();
  if (triangles.empty() && share > 0) {
    std::vector<Vec2> spare;
    result.region = box_around(placement.vertices);
    for (const Side& side : sides) {
      if (!result.region.empty()) cut(result.region, side, most, spare);
    }
    return result;
  }
  std::vector<Vec2> area, spare;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    area.assign({placement.vertices[triangles[i]], placement.vertices[triangles[i + 1]],
                 placement.vertices[triangles[i + 2]]});
    for (const Side& side : sides) {
      if (share == 0 || area.empty()) break;
      cut(area, side, most, spare);
    }
    for (std::size_t j = 2; j < area.size(); ++j) {
      result.triangles.insert(result.triangles.end(), {area[0], area[j - 1], area[j]});
    }
  }
  return result;
}

}  // namespace

std::vector<HeatBand> heat_bands(const Placement& placement,
                                 const std::vector<std::uint32_t>& triangles) {
  if (placement.lifting_base.size() < 3) return {};
  const std::vector<Side> sides = cutting_sides(placement);
  std::vector<HeatBand> bands{band(placement, triangles, sides, 0)};
  for (const double level : heat_levels) bands.push_back(band(placement, triangles, sides, level));
  bands.push_back(band(placement, triangles, sides, std::numeric_limits<double>::infinity()));
  return bands;
}

}  // namespace evenlift::view
