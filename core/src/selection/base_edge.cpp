#include "selection/base_edge.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/hull.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "polygon/clip.h"

namespace evenlift {
namespace {

// Bounds are raised by these, so that rounding cannot make them too low: the area of a clipped
// polygon (in units of L^2), each summed distance (in units of L), and areas (by a factor). Each is
// at least a thousand times the error; the only cost is a few more full evaluations.
constexpr double clipping = 1e-13, per_distance = 1e-12, rounded_up = 1 + 1e-9;

// The signed distance of v from the line a -> b, positive to the right: outside, for an edge of H.
double distance_outside(const Vec2& a, const Vec2& b, const Vec2& v) {
  const Vec2 line = b - a;
  return -cross(line, v - a) / length(line);
}

// distance_outside() for one line and many points.
class Outside {
 public:
  Outside(const Vec2& a, const Vec2& b) : start_(a), line_(b - a), length_(length(line_)) {}
  double distance(const Vec2& v) const { return -cross(line_, v - start_) / length_; }

 private:
  Vec2 start_, line_;
  double length_;
};

double triangle_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return 0.5 * std::fabs(cross(b - a, c - a));
}

double inscribed_circle_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double perimeter = length(b - a) + length(c - b) + length(a - c);
  const double radius = 2 * triangle_area(a, b, c) / perimeter;
  return pi * radius * radius;
}

}  // namespace

Surroundings::Surroundings(const PolygonWithHoles& object, const Vec2& centre)
    : convex(object.convex()), diameter(object.outline().diameter()) {
  const Polygon& polygon = object.outline();
  boundary.reserve(object.boundary().size());
  for (const Vec2& v : object.boundary()) boundary.push_back(v - centre);
  vertices.reserve(polygon.size());
  for (const Vec2& v : polygon.vertices()) {
    const Vec2 relative = v - centre;
    if (v != centre) vertices.push_back({relative, pseudo_angle(relative)});
  }
  if (!polygon.counter_clockwise()) std::reverse(boundary.begin(), boundary.end());
  std::sort(vertices.begin(), vertices.end(), [](const Seen& a, const Seen& b) {
    if (a.pseudo_angle != b.pseudo_angle) return a.pseudo_angle < b.pseudo_angle;
    if (a.position.x != b.position.x) return a.position.x < b.position.x;
    return a.position.y < b.position.y;
  });
}

Wedge::Wedge(const Surroundings& surroundings, Metric metric, const Vec2& h1, const Vec2& h2)
    : surroundings_(&surroundings),
      metric_(metric),
      h1_(h1),
      h2_(h2),
      pseudo_angle1_(pseudo_angle(h1)) {
  if (metric == Metric::area && !surroundings.convex) collect_area();
  if (metric == Metric::distance) collect_outer_vertices();
}

// Only the area in the triangle h1 h2 p counts in the end. To save time, this removes the area that
// C does not see between h1 and h2, except for a rim: p in a corner's direction may miss it by half
// the rim's width.
void Wedge::collect_area() {
  outside_ = clip_left(surroundings_->boundary, h2_, h1_);
  if (is_convex()) {
    const auto clip = [&](const Vec2& direction) {
      const Vec2 outward = -left_normal(direction) / length(direction);
      const double rim = 2 * near_distance(surroundings_->diameter);
      outside_ = clip_left_of_ray(outside_, rim * outward, direction);
    };
    clip(h1_);
    clip(-h2_);
  }
  outside_area_ = signed_area(outside_);
}

// If C is on the edge, rounding decides its side; the result is still true.
bool Wedge::is_convex() const {
  const double past_180 = -cross(h1_, h2_) / std::min(length(h1_), length(h2_));
  constexpr double rounding = 0x1p-44;
  return past_180 <= rounding * surroundings_->diameter;
}

void Wedge::collect_outer_vertices() {
  sums_.push_back(Vec2{});
  const auto seen = [](const Surroundings::Seen& item) -> const Surroundings::Seen& {
    return item;
  };
  const auto note = [&](const Surroundings::Seen& vertex, SeenAt seen_at) {
    // A vertex within H adds nothing. But if H is a segment, a vertex in a corner's direction may
    // be beyond it on the segment's line: not outside that line, yet outside the new edge.
    const double distance = std::max(0.0, this->distance(vertex.position));
    if (distance == 0 && seen_at == SeenAt::between) return;
    outer_.push_back(
        {vertex.position, pseudo_angle_from(pseudo_angle1_, vertex.pseudo_angle), distance});
    sums_.push_back(sums_.back() + vertex.position);
    distance_sum_ += distance;
  };
  for_each_between(surroundings_->vertices, seen, h1_, h2_, note);
}

double Wedge::distance(const Vec2& p) const { return distance_outside(h1_, h2_, p); }

Gain Wedge::estimate(const Vec2& p) const {
  switch (metric_) {
    case Metric::circle:
      return {inscribed_circle_area(h1_, h2_, p), Certainty::exact};
    case Metric::distance:
      return {distance_bound(p), Certainty::bound};
    case Metric::area:
      break;
  }
  const double triangle = triangle_area(h1_, h2_, p);
  if (surroundings_->convex) return {triangle, Certainty::exact};
  const double error = clipping * surroundings_->diameter * surroundings_->diameter;
  return {std::min(triangle, outside_area_) * rounded_up + error, Certainty::bound};
}

double Wedge::evaluate(const Vec2& p) const {
  switch (metric_) {
    case Metric::circle:
      return inscribed_circle_area(h1_, h2_, p);
    case Metric::distance:
      return distance_gain(p);
    case Metric::area:
      break;
  }
  return surroundings_->convex ? triangle_area(h1_, h2_, p) : area_gain(p);
}

double Wedge::area_gain(const Vec2& p) const { return area_left_of_both(outside_, h1_, p, h2_); }

Wedge::Split Wedge::split_at(const Vec2& p) const {
  const double angle = pseudo_angle_from(pseudo_angle1_, pseudo_angle(p));
  const auto at =
      std::upper_bound(outer_.begin(), outer_.end(), angle,
                       [](double value, const Outer& outer) { return value < outer.pseudo_angle; });
  auto begin = at, end = at;
  while (begin != outer_.begin() && directions_agree(p, (begin - 1)->position)) --begin;
  while (end != outer_.end() && directions_agree(p, end->position)) ++end;
  return {static_cast<std::size_t>(begin - outer_.begin()),
          static_cast<std::size_t>(end - outer_.begin())};
}

// Calls visit(vertex, distance outside the new edge, whether this edge is h1 p). A vertex in the
// direction of p keeps its longer arm, so that mirror images have the same sum.
template <class Visit>
void Wedge::for_each_arm(const Vec2& p, Visit visit) const {
  const Split split = split_at(p);
  const Outside before(h1_, p), behind(p, h2_);
  std::size_t k = 0;
  for (; k < split.begin; ++k) visit(outer_[k], before.distance(outer_[k].position), true);
  for (; k < split.end; ++k) {
    const double up_to_p = before.distance(outer_[k].position);
    const double from_p = behind.distance(outer_[k].position);
    visit(outer_[k], std::max(up_to_p, from_p), up_to_p >= from_p);
  }
  for (; k < outer_.size(); ++k) visit(outer_[k], behind.distance(outer_[k].position), false);
}

double Wedge::distance_gain(const Vec2& p) const {
  double gain = 0;
  for_each_arm(p, [&](const Outer& outer, double left, bool) {
    gain += outer.distance - std::max(0.0, left);
  });
  return gain;
}

std::vector<Wedge::Arm> Wedge::arms(const Vec2& p) const {
  std::vector<Arm> arms;
  for_each_arm(p, [&](const Outer& outer, double left, bool up_to_p) {
    arms.push_back({outer.position, outer.distance, std::max(0.0, left), up_to_p});
  });
  return arms;
}

double Wedge::distance_bound(const Vec2& p) const {
  // The sum of positive parts is at least the positive part of the sum. The sum of distances from a
  // line follows from the sum of positions.
  const auto sum_outside = [](const Vec2& a, const Vec2& b, const Vec2& sum, std::size_t number) {
    const Vec2 line = b - a;
    return -cross(line, sum - static_cast<double>(number) * a) / length(line);
  };
  const std::size_t split = split_at(p).end, n = outer_.size();
  const double left1 = sum_outside(h1_, p, sums_[split], split);
  const double left2 = sum_outside(p, h2_, sums_[n] - sums_[split], n - split);
  return distance_sum_ - std::max(0.0, left1) - std::max(0.0, left2) + distance_error_bound();
}

double Wedge::distance_error_bound() const {
  return per_distance * surroundings_->diameter * static_cast<double>(outer_.size() + 1);
}

Gain Wedge::sharpen(const Vec2& p, const Gain& known) {
  if (known.certainty == Certainty::bound && prepare_close_bounds()) {
    return {std::min(known.value, close_bound(p)), Certainty::close_bound};
  }
  return {evaluate(p), Certainty::exact};
}

// Makes the close bounds once they are likely to save time. Returns whether they exist.
bool Wedge::prepare_close_bounds() {
  if (area_bins_ || distance_blocks_) return true;
  constexpr std::size_t few_vertices = 48;
  constexpr int few_evaluations = 4;
  constexpr double narrow = 1e-3;  // rounding would spoil narrower wedges
  if (std::max(outside_.size(), outer_.size()) < few_vertices || ++evaluations_ <= few_evaluations)
    return false;
  switch (metric_) {
    case Metric::area:
      if (!is_convex() || pseudo_angle_from(pseudo_angle1_, pseudo_angle(h2_)) < narrow)
        return false;
      area_bins_.emplace(outside_, h1_, h2_, surroundings_->diameter);
      return true;
    case Metric::distance: {
      Points positions;
      positions.reserve(outer_.size());
      for (const Outer& outer : outer_) positions.push_back(outer.position);
      distance_blocks_.emplace(std::move(positions));
      return true;
    }
    case Metric::circle:  // estimated exactly
      break;
  }
  return false;
}

double Wedge::close_bound(const Vec2& p) const {
  if (area_bins_) return area_bins_->bound(p) * rounded_up;
  const std::size_t split = split_at(p).end;
  return distance_sum_ - distance_blocks_->least_sum_beyond(h1_, p, 0, split) -
         distance_blocks_->least_sum_beyond(p, h2_, split, outer_.size()) + distance_error_bound();
}

}  // namespace evenlift
