// What searches keep away from so that robots may be off their places.
#pragma once

#include <vector>

#include "evenlift/stands.h"

namespace evenlift {

// By edge: how far any part of a robot at this edge may move if the robot is off along the outline by
// up to `accuracy`. Past a bend the normal turns, and with it the part, which is up to `arm` from the
// contact. O(n + the vertices within `accuracy` of each edge's ends).
std::vector<double> drifts(const Polygon& polygon, double arm, double accuracy);

// How much of the outline before or after a vertex no robot may use, because an end of the room is
// near beyond it.
class RoomBeyond {
 public:
  // The arguments must outlive this object. O(1).
  RoomBeyond(const Polygon& polygon, const Stands& stands, const StandReserve& reserve, double near)
      : polygon_(polygon), stands_(stands), reserve_(reserve), near_(near) {}

  // `on` is the direction in which the outline goes on beyond the vertex: that of the list of
  // vertices, or the opposite one. Nothing if the room ends at the vertex. O(vertices within
  // `accuracy`).
  struct Kept {
    double length = 0;
    bool is_end = false;  // whether the room ends at the vertex
  };
  Kept kept(std::size_t vertex, bool on) const;

 private:
  const Polygon& polygon_;
  const Stands& stands_;
  StandReserve reserve_;
  double near_;
};

}  // namespace evenlift
