#include "picture/heat.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

#include "evenlift/plane.h"
#include "picture/triangulate.h"

namespace evenlift::view {
namespace {

// A side of the lifting base. Distances beyond it are in units of its distance from the farthest
// place towards it where the weight may act.
struct Side {
  Vec2 a, along;
  double within;
  double beyond(const Vec2& p) const { return -cross(along, p - a) / within; }
};

// With thousands of corners a base is practically round: not all of its sides are needed.
constexpr std::size_t most_sides = 1000;

// Those with a vertex beyond them; the others cut nothing off. The weight acts within `reach` of C.
std::vector<Side> cutting_sides(const Placement& placement, double reach) {
  std::vector<Side> sides;
  const Points& hull = placement.lifting_base;
  const std::size_t step = (hull.size() + most_sides - 1) / most_sides;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const Vec2 along = hull[i + 1 == hull.size() ? 0 : i + 1] - hull[i];
    Side side{hull[i], along,
              cross(along, placement.centre_of_mass - hull[i]) - reach * length(along)};
    // At the very edge, nearly any press tips it.
    if (reach > 0) side.within = std::max(side.within, 1e-9 * reach * length(along));
    if (!(side.within > 0)) continue;
    const bool cuts = std::any_of(placement.vertices().begin(), placement.vertices().end(),
                                  [&](const Vec2& p) { return side.beyond(p) > 0; });
    if (cuts) sides.push_back(side);
  }
  return sides;
}

// Keeps the part at most `most` beyond the side. `spare` is memory for reuse.
void cut(Points& area, const Side& side, double most, Points& spare) {
  clip(
      area, [&](const Vec2& p) { return most - side.beyond(p); }, spare);
  area.swap(spare);
}

// With ample room, counter-clockwise.
Points frame_around(const Points& polygon) {
  const Box box = bounding_box(polygon);
  const Vec2 low = box.low - box.size(), high = box.high + box.size();
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

HeatBand band(const Placement& placement, const Points& corners,
              const std::vector<std::uint32_t>& triangles, const std::vector<Side>& sides,
              double share) {
  HeatBand result{share, {}, {}};
  const double most = share > 0 ? 1 / share : std::numeric_limits<double>::infinity();
  if (triangles.empty() && share > 0) {
    Points spare;
    result.region = frame_around(placement.vertices());
    for (const Side& side : sides) {
      if (!result.region.empty()) cut(result.region, side, most, spare);
    }
    return result;
  }
  Points area, spare;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    area.assign({corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]});
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

std::vector<HeatBand> heat_bands(const Reported& of, const std::vector<std::uint32_t>& triangles) {
  const Placement& placement = of.placement;
  if (placement.lifting_base.size() < 3) return {};
  const std::vector<Side> sides = cutting_sides(placement, of.report.effect.reach);
  const Points corners = joined(placement.vertices(), placement.object.rings_of_holes());
  std::vector<HeatBand> bands;
  const auto add = [&](double share) {
    bands.push_back(band(placement, corners, triangles, sides, share));
  };
  add(0);
  if (of.report.tips) return bands;
  for (const double level : heat_levels) add(level);
  add(std::numeric_limits<double>::infinity());
  return bands;
}

}  // namespace evenlift::view
