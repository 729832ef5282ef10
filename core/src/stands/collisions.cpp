#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/stands.h"

namespace evenlift {
namespace {

struct Segment {
  Vec2 from, to;
};

// Whether the other's ends are on different sides of the line, by more than `near`.
bool parts_ends(const Segment& line, const Segment& other, double near) {
  const double close = near * length(line.to - line.from);
  const double a = orient(line.from, line.to, other.from), b = orient(line.from, line.to, other.to);
  return std::fabs(a) > close && std::fabs(b) > close && (a > 0) != (b > 0);
}

// By more than `near`; segments that touch do not cross.
bool cross_each_other(const Segment& a, const Segment& b, double near) {
  return parts_ends(a, b, near) && parts_ends(b, a, near);
}

double distance_of_segments(const Segment& a, const Segment& b) {
  if (cross_each_other(a, b, 0)) return 0;
  return std::min(
      {distance_to_segment(b.from, b.to, a.from), distance_to_segment(b.from, b.to, a.to),
       distance_to_segment(a.from, a.to, b.from), distance_to_segment(a.from, a.to, b.to)});
}

}  // namespace

bool Stands::bodies_collide(const LiftingPoint& a, const LiftingPoint& b) const {
  const double apart = 2 * robot_.radius + robot_.gap + reserve_between(a, b) - near_;
  return apart > 0 && length(stand(a) - stand(b)) < apart;
}

// Without a reach, an arm is inside its body, which keeps others away.
bool Stands::arms_collide(const LiftingPoint& a, const LiftingPoint& b) const {
  if (robot_.reach <= 0) return false;
  const Segment arm_a{contact(a), stand(a)}, arm_b{contact(b), stand(b)};
  const double reserve = reserve_between(a, b),
               clear = robot_.radius + robot_.gap + reserve - near_;
  return (reserve > 0 && distance_of_segments(arm_a, arm_b) < reserve) ||
         (clear > 0 && (distance_to_segment(arm_a.from, arm_a.to, arm_b.to) < clear ||
                        distance_to_segment(arm_b.from, arm_b.to, arm_a.to) < clear)) ||
         cross_each_other(arm_a, arm_b, near_);
}

bool Stands::hands_collide(const LiftingPoint& a, const LiftingPoint& b) const {
  if (a.edge == beneath || b.edge == beneath) return false;
  return robot_.width > near_ &&
         distance_of_segments({contact(a), a.position}, {contact(b), b.position}) <
             robot_.width + reserve_between(a, b) - near_;
}

double Stands::reserve_between(const LiftingPoint& a, const LiftingPoint& b) const {
  return drifts_.empty() || a.edge == beneath || b.edge == beneath
             ? 0
             : drifts_[a.edge] + drifts_[b.edge];
}

bool Stands::collide(const LiftingPoint& a, const LiftingPoint& b) const {
  return bodies_collide(a, b) || arms_collide(a, b) || hands_collide(a, b);
}

double Stands::room_between(const LiftingPoint& a, const LiftingPoint& b) const {
  double room = std::numeric_limits<double>::infinity();
  if (const double apart = 2 * robot_.radius + robot_.gap; apart > 0)
    room = length(stand(a) - stand(b)) - apart;
  if (robot_.reach > 0) {
    const Segment arm_a{contact(a), stand(a)}, arm_b{contact(b), stand(b)};
    const double clear = robot_.radius + robot_.gap;
    room = std::min({room, distance_to_segment(arm_a.from, arm_a.to, arm_b.to) - clear,
                     distance_to_segment(arm_b.from, arm_b.to, arm_a.to) - clear,
                     distance_of_segments(arm_a, arm_b)});
  }
  if (robot_.width > near_ && a.edge != beneath && b.edge != beneath)
    room = std::min(room, distance_of_segments({contact(a), a.position}, {contact(b), b.position}) -
                              robot_.width);
  return room;
}

bool Stands::any_collide(const std::vector<LiftingPoint>& points) const {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (collide(points[i], points[j])) return true;
  return false;
}

}  // namespace evenlift
