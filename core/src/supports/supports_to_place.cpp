// Finds places for robots that the user is about to move.
#include <cmath>

#include "evenlift/plane.h"
#include "evenlift/supports.h"

namespace evenlift {
namespace {

// Rounds to about a thousandth of a length, so that coordinates and links are short.
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

}  // namespace

Points supports_to_place(const PolygonWithHoles& object, const Vec2& centre, std::size_t robots,
                         const Settings& settings) {
  const Polygon& polygon = object.outline();
  Vec2 corner = centre;
  for (const Vec2& vertex : polygon.vertices())
    if (length(vertex - centre) > length(corner - centre)) corner = vertex;
  const SupportPlacer placer(object, settings);
  const ShortNumbers rounded(polygon.diameter());
  // Smaller until all are inside the object.
  for (double size = 0.15 * polygon.diameter(); size > 1e-3 * polygon.diameter(); size /= 2) {
    const Vec2 middle = centre + 0.8 * size / length(corner - centre) * (corner - centre);
    Points supports;
    for (std::size_t i = 0; i < robots; ++i) {
      // Along the sides of a square, from its corner at the lower left.
      const double way = 4.0 * static_cast<double>(i) / static_cast<double>(robots);
      const double part = 2 * (way - std::floor(way)) - 1;
      const Vec2 leg = way < 1   ? Vec2(part, -1)
                       : way < 2 ? Vec2(1, part)
                       : way < 3 ? Vec2(-part, 1)
                                 : Vec2(-1, -part);
      const Vec2 at = middle + size * leg;
      const Vec2 short_at(rounded(at.x()), rounded(at.y()));
      if (placer.place(short_at)) supports.push_back(short_at);
    }
    if (supports.size() == robots) return supports;
  }
  return Points(robots, polygon.vertex(0));
}

}  // namespace evenlift
