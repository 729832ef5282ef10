// The equirectangular projection of WGS 84 from degrees to metres, true to scale at the latitude of
// its origin.
#pragma once

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// The greatest latitude, in degrees. Nearer to a pole, widths vary too much with the latitude.
inline constexpr double greatest_latitude = 85;

// A degree of longitude (x) and of latitude (y) at a latitude in degrees, in metres on the ellipsoid. O(1).
Vec2 degree_at(double latitude);

// The relative error of a length, compared with the geodesic, is at most the error of a width (from
// west to east) at the latitude farthest from the origin. If the places lie in a square with a side
// of 1 km about the origin, this error is 0.005 % at latitude 30, 0.014 % at 60 and 0.05 % at 80;
// in a square with a side of 10 km it is ten times larger. All platforms compute the same bits,
// since sines and cosines come from angles.h.
class Projection {
 public:
  // The box has longitudes (x) and latitudes (y) in degrees. The origin is the middle of the box,
  // rounded to four decimals so that a message can state it. Returns an error if a longitude is
  // beyond 180 degrees, if a latitude is beyond greatest_latitude, or if the box is wider than 180
  // degrees: then the places are probably on both sides of the 180th meridian. O(1).
  static Result<Projection> about_middle(const Box& box);

  // Metres east (x) and north (y) of the origin. O(1).
  Vec2 metres(const Vec2& degrees) const {
    return componentwise_product(degrees - origin_, scale_);
  }

  // The origin in degrees, with at most four decimals.
  const Vec2& origin() const { return origin_; }
  // The length in metres of a degree of longitude or latitude, whichever is longer.
  double greatest_scale() const { return max_norm(scale_); }
  // The greatest relative error of a width in the box.
  double error() const { return error_; }

 private:
  Projection(const Vec2& origin, const Box& box);

  Vec2 origin_, scale_;
  double error_;
};

}  // namespace evenlift
