// The equirectangular projection of WGS 84 from degrees to metres, true to scale at the latitude of
// its origin.
#pragma once

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// In degrees. Nearer to a pole, widths vary too much with the latitude.
inline constexpr double greatest_latitude = 85;

// Compared with the geodesic, the relative error of a length is at most that of a width at the
// latitude farthest from the origin. In a square of 1 km about the origin this error is 0.005 % at
// latitude 30, 0.014 % at 60 and 0.05 % at 80; in a square of 10 km it is ten times larger. All
// platforms compute the same bits, since sines and cosines come from angles.h.
class Projection {
 public:
  // The box has longitudes (x) and latitudes (y) in degrees. The origin is the middle of the box,
  // rounded to four decimals so that words can name it. Returns an error if a longitude is beyond
  // 180, if a latitude is beyond 90 or greatest_latitude, or if the box is wider than 180 and so
  // spans the 180th meridian. O(1).
  static Result<Projection> about_middle(const Box& box);

  // Metres east (x) and north (y) of the origin. O(1).
  Vec2 metres(const Vec2& degrees) const { return (degrees - origin_).cwiseProduct(scale_); }

  // The origin in degrees, with at most four decimals.
  const Vec2& origin() const { return origin_; }
  // The length of a degree in metres, in the longer direction.
  double greatest_scale() const { return scale_.maxCoeff(); }
  // The greatest relative error of a width in the box.
  double error() const { return error_; }

 private:
  Projection(const Vec2& origin, const Box& box);

  Vec2 origin_, scale_;
  double error_;
};

}  // namespace evenlift
