// Places for robots that the user will move.
#include <algorithm>
#include <cmath>
#include <vector>

#include "evenlift/plane.h"
#include "evenlift/supports.h"

namespace evenlift {
namespace {

// Rounds to about a thousandth of a length, for short coordinates and links.
class ShortNumbers {
 public:
  explicit ShortNumbers(double length) {
    for (; length * up_ / down_ < 1e3; up_ *= 10) continue;
    for (; length * up_ / down_ >= 1e4; down_ *= 10) continue;
  }
  double operator()(double value) const { return std::round(value * up_ / down_) * down_ / up_; }

 private:
  double up_ = 1, down_ = 1;  // powers of ten; one of them is 1
};

// Places along the sides of a square, from its lower left corner; none if one is outside the
// object. `size` is half a side.
Points on_square(const SupportPlacer& placer, const ShortNumbers& rounded, const Vec2& middle,
                 double size, std::size_t robots) {
  Points supports;
  for (std::size_t i = 0; i < robots; ++i) {
    const double way = 4.0 * static_cast<double>(i) / static_cast<double>(robots);
    const double part = 2 * (way - std::floor(way)) - 1;
    const Vec2 leg = way < 1   ? Vec2(part, -1)
                     : way < 2 ? Vec2(1, part)
                     : way < 3 ? Vec2(-part, 1)
                               : Vec2(-1, -part);
    const Vec2 at = middle + size * leg;
    const Vec2 short_at(rounded(at.x), rounded(at.y));
    if (!placer.place(short_at)) return {};
    supports.push_back(short_at);
  }
  return supports;
}

// Offsets of the square's middle from C, in units of `size`: `wanted`, then others with C inside
// the square, the nearest to `wanted` first.
std::vector<Vec2> middles(const Vec2& wanted) {
  std::vector<Vec2> all = {wanted};
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y) all.push_back(Vec2(0.3 * x, 0.3 * y));
  std::stable_sort(all.begin(), all.end(), [&](const Vec2& a, const Vec2& b) {
    return length(a - wanted) < length(b - wanted);
  });
  return all;
}

}  // namespace

Points supports_to_place(const PolygonWithHoles& object, const Vec2& centre, std::size_t robots,
                         const Settings& settings) {
  const Polygon& polygon = object.outline();
  Vec2 corner = centre;
  for (const Vec2& vertex : polygon.vertices())
    if (length(vertex - centre) > length(corner - centre)) corner = vertex;
  const SupportPlacer placer(object, settings);
  const double diameter = polygon.diameter(), largest = 0.15 * diameter;
  const ShortNumbers rounded(diameter);
  const std::vector<Vec2> offsets = middles(0.8 / length(corner - centre) * (corner - centre));
  const auto fits = [&](const Vec2& offset, double size) {
    return on_square(placer, rounded, centre + size * offset, size, robots);
  };
  for (const double size : {largest, largest / 2})
    if (Points supports = fits(offsets[0], size); !supports.empty()) return supports;
  // On smaller squares robots hide each other, so the middle may be elsewhere.
  for (double size = largest; size > 1e-3 * diameter; size /= 2)
    for (const Vec2& offset : offsets)
      if (Points supports = fits(offset, size); !supports.empty()) return supports;
  return Points(robots, polygon.vertex(0));
}

}  // namespace evenlift
