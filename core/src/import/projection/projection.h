// Places on the earth in degrees as metres on a plane: the equirectangular projection, with true
// scale at the latitude of its origin, of the ellipsoid WGS 84.
#pragma once

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// Nearer to a pole, widths depend too much on the latitude.
inline constexpr double greatest_latitude = 85;

// The relative error of a length, against the geodesic on the ellipsoid, is at most that of a width
// at the latitude farthest from the origin. In a square of 1 km about the origin it is 0.005 % at
// latitude 30, 0.014 % at 60 and 0.05 % at 80; in one of 10 km it is ten times as much. Computed
// with the functions of angles.h, so it has the same bits on every platform.
class Projection {
 public:
  // The projection about the middle of a box of longitudes (x) and latitudes (y) in degrees, rounded
  // to four decimals, so that words can name its origin. An error if a longitude is beyond 180 or a
  // latitude beyond 90, which are no degrees, if a latitude is beyond greatest_latitude, or if the box
  // is wider than 180, since it then spans the 180th meridian. O(1).
  static Result<Projection> about_middle(const Box& box);

  // The metres east (x) and north (y) of the origin. O(1).
  Vec2 metres(const Vec2& degrees) const { return (degrees - origin_).cwiseProduct(scale_); }

  // In degrees, each with at most four decimals.
  const Vec2& origin() const { return origin_; }
  // The length of a degree in metres, along the longer of its two directions.
  double greatest_scale() const { return scale_.maxCoeff(); }
  // The greatest relative error of a width in the box.
  double error() const { return error_; }

 private:
  Projection(const Vec2& origin, const Box& box);

  Vec2 origin_, scale_;
  double error_;
};

}  // namespace evenlift
