#include "import/projection/projection.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"

namespace evenlift {
namespace {

// WGS 84; the half axis is in metres.
constexpr double half_axis = 6378137;
constexpr double flattening = 1 / 298.257223563;
constexpr double eccentricity_squared = flattening * (2 - flattening);

double with_four_decimals(double value) { return std::floor(value * 10000 + 0.5) / 10000; }

InputError refused(const char* why) { return {ErrorCode::bad_coordinate, why}; }

}  // namespace

Vec2 degree_at(double latitude) {
  const double angle = latitude * (pi / 180);
  const double height = sine(angle);
  const double square = 1 - eccentricity_squared * height * height;
  const double across = half_axis / std::sqrt(square);  // radius in the prime vertical
  const double along = across * (1 - eccentricity_squared) / square;  // of the meridian
  return Vec2(across * cosine(angle), along) * (pi / 180);
}

Projection::Projection(const Vec2& origin, const Box& box)
    : origin_(origin), scale_(degree_at(origin.y)) {
  const double south = degree_at(box.low.y).x, north = degree_at(box.high.y).x;
  error_ = std::max(std::abs(scale_.x / south - 1), std::abs(scale_.x / north - 1));
}

Result<Projection> Projection::about_middle(const Box& box) {
  const auto beyond = [&](std::size_t axis, double limit) {
    return box.low[axis] < -limit || box.high[axis] > limit;
  };
  if (beyond(0, 180) || beyond(1, 90))
    return refused(
        "the coordinates are not degrees: a longitude is beyond 180, or a latitude beyond 90");
  if (beyond(1, greatest_latitude))
    return refused("a latitude is beyond 85 degrees, too near a pole for a plane in metres");
  static_assert(greatest_latitude == 85, "the message names the number");
  if (box.size().x > 180) return refused("the coordinates are on both sides of the 180th meridian");
  const Vec2 middle = box.middle();
  return Projection({with_four_decimals(middle.x), with_four_decimals(middle.y)}, box);
}

}  // namespace evenlift
