#include "chords/section.h"

#include <cmath>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"

namespace evenlift {

Across look_across(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c,
                   double doubled_area) {
  // With X = (C - w) x (c - b) and h = (b - C) x (c - C), the doubled area, the factor is h / X.
  // The sign of h - X shows on which side of the edge the mirror image of w lies. That difference
  // is accurate, so factors near 1 are accurate relative to their difference from 1.
  const double x = cross_of_differences(w, centre, b, c);
  const double difference = orient_mirrored(centre, w, b, c);
  Across across;
  across.compare_to_one = (difference > 0) - (difference < 0);
  if (std::fabs(difference) < 0.5 * x) {
    across.factor = 1.0 + difference / x;
  } else {
    across.factor = doubled_area / x;
  }
  return across;
}

std::optional<double> estimate_across(const Vec2& centre, const Vec2& w, const Vec2& b,
                                      const Vec2& c, double doubled_area) {
  const double first = (centre.x - w.x) * (c.y - b.y), second = (centre.y - w.y) * (c.x - b.x);
  // The two products together have an error below 2^-50 of their sizes; the relative error of the
  // area is below 2^-45.
  constexpr double filter_threshold = 0x1p-15, smallest_safe = 0x1p-800;
  const double x = first - second, size = std::fabs(first) + std::fabs(second);
  if (!(x > filter_threshold * size && size > smallest_safe)) return std::nullopt;
  return doubled_area / x;
}

bool points_right(const Vec2& direction) {
  return is_vertical(direction) ? direction.y > 0 : direction.x > 0;
}

double load_ratio(double arm1, double arm2) { return arm1 < arm2 ? arm1 / arm2 : arm2 / arm1; }

Chord order_ends(const LiftingPoint& ahead, double arm_ahead, const LiftingPoint& behind,
                 double arm_behind, const Vec2& direction) {
  Chord chord{behind, ahead, arm_behind, arm_ahead, load_ratio(arm_ahead, arm_behind)};
  if (!points_right(direction)) {
    std::swap(chord.r1, chord.r2);
    std::swap(chord.arm1, chord.arm2);
  }
  return chord;
}

Chord chord_from_vertex(const Polygon& polygon, const Vec2& centre, std::uint32_t w,
                        std::uint32_t edge_w, const Across& across, std::uint32_t edge_hit,
                        std::uint32_t hit) {
  const Vec2& position = polygon.vertex(w);
  const Vec2 direction = centre - position;
  const double arm = length(direction);
  const bool at_vertex = hit != inside_edge;
  const Vec2 far = at_vertex ? polygon.vertex(hit) : Vec2(centre + across.factor * direction);
  const LiftingPoint start{position, edge_w}, end{far, edge_hit};
  Chord chord = order_ends(end, across.factor * arm, start, arm, direction);
  // From the factor, which is exact if the halves are equal, not from the arms.
  chord.ratio = across.compare_to_one > 0 ? 1.0 / across.factor : across.factor;
  return chord;
}

bool same_chord(const Chord& a, const Chord& b, double near) {
  const auto close = [&](const LiftingPoint& p, const LiftingPoint& q) {
    return length(p.position - q.position) <= near;
  };
  return (close(a.r1, b.r1) && close(a.r2, b.r2)) || (close(a.r1, b.r2) && close(a.r2, b.r1));
}

}  // namespace evenlift
