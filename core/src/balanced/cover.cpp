#include "balanced/cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace evenlift::balanced {

// The object within H has the area of a closed curve: the boundary of the object, with all parts
// outside H pulled along the rays to C onto the boundary of H. A part inside H adds its triangle
// with C; any other part adds the sector of H between the directions of its ends. Points are
// relative to C.
class Cover::Sum {
 public:
  Sum(const Cover& cover, const SmallHull& hull)
      : cover_(cover), boundary_(cover.object_.boundary()), hull_(hull) {
    for (std::size_t i = 0; i < hull.size; ++i) {
      const Vec2 &a = hull.corners[i], along = next_corner(i) - a;
      normals_[i] = {along.y, -along.x};
      bounds_[i] = dot(normals_[i], a);
      sectors_[i + 1] = sectors_[i] + cross(a, next_corner(i));
    }
  }

  // Whether C is inside H, and not only through rounding. (If two teams stand on one chord, only
  // rounding gives H an area, and C sees its sides end on.)
  bool is_sound() const {
    if (hull_.size < 3) return false;
    double reach = 0;
    for (std::size_t i = 0; i < hull_.size; ++i) reach = std::max(reach, length(hull_.corners[i]));
    for (std::size_t i = 0; i < hull_.size; ++i)
      if (bounds_[i] <= rounding * reach * length(normals_[i])) return false;
    return true;
  }

  double area() {
    visit(0);
    return std::fabs(doubled_area_) / 2;
  }

  std::uint64_t steps() const { return visits_ * hull_.size / 3; }

 private:
  // Smaller shares of H's area, and smaller distances as shares of its reach, are rounding.
  static constexpr double rounding = 1e-12;

  enum class Side { inside, outside, both };

  const Vec2& next_corner(std::size_t i) const {
    return hull_.corners[i + 1 == hull_.size ? 0 : i + 1];
  }

  Vec2 vertex(std::size_t i) const { return boundary_[i] - cover_.centre_; }

  Side side_of(const Box& box) const {
    const Vec2 middle = (box.low + box.high) / 2 - cover_.centre_, half = (box.high - box.low) / 2;
    Side side = Side::inside;
    for (std::size_t i = 0; i < hull_.size; ++i) {
      const double at = dot(normals_[i], middle) - bounds_[i];
      const double reach = std::fabs(normals_[i].x) * half.x + std::fabs(normals_[i].y) * half.y;
      if (at >= reach) return Side::outside;
      if (at > -reach) side = Side::both;
    }
    return side;
  }

  void visit(std::uint32_t i) {
    const EdgeTree::Node& node = cover_.tree_.node(i);
    ++visits_;
    switch (side_of(node.box)) {
      case Side::inside:
        doubled_area_ += cover_.doubled_areas_[node.end] - cover_.doubled_areas_[node.begin];
        return;
      case Side::outside:
        return add_sector(vertex(node.begin), end_of(node.end - 1));
      case Side::both:
        break;
    }
    if (!node.is_leaf()) {
      visit(node.left);
      return visit(node.right);
    }
    visits_ += node.end - node.begin;
    for (std::uint32_t edge = node.begin; edge < node.end; ++edge)
      add_edge(vertex(edge), end_of(edge));
  }

  Vec2 end_of(std::uint32_t edge) const {
    return vertex(edge + 1 == boundary_.size() ? 0 : edge + 1);
  }

  // The part in H runs from `a + enter * (b - a)` to `a + leave * (b - a)`.
  void add_edge(const Vec2& a, const Vec2& b) {
    double enter = 0, leave = 1;
    for (std::size_t i = 0; i < hull_.size; ++i) {
      const double at_a = dot(normals_[i], a) - bounds_[i], at_b = dot(normals_[i], b) - bounds_[i];
      if (at_a >= 0 && at_b >= 0) return add_sector(a, b);
      if (at_a > 0) enter = std::max(enter, at_a / (at_a - at_b));
      if (at_b > 0) leave = std::min(leave, at_a / (at_a - at_b));
    }
    if (enter >= leave) return add_sector(a, b);
    const Vec2 first = enter > 0 ? Vec2(a + enter * (b - a)) : a,
               last = leave < 1 ? Vec2(a + leave * (b - a)) : b;
    if (enter > 0) add_sector(a, first);
    doubled_area_ += cross(first, last);
    if (leave < 1) add_sector(last, b);
  }

  // For a part outside H, seen from C at less than 180 degrees.
  void add_sector(const Vec2& a, const Vec2& b) {
    const double turn = cross(a, b), all = sectors_[hull_.size];
    // Most parts begin where the last one ended, and reuse its sector.
    const double before_a = a == last_ ? before_last_ : sector_before(a);
    last_ = b;
    before_last_ = sector_before(b);
    double sector = before_last_ - before_a;
    if (turn >= 0 && sector < -rounding * all) sector += all;
    if (turn <= 0 && sector > rounding * all) sector -= all;
    doubled_area_ += sector;
  }

  // Twice the area of H from the first corner counter-clockwise to a direction.
  double sector_before(const Vec2& direction) const {
    std::size_t i = 0;
    while (i + 1 < hull_.size &&
           !(cross(hull_.corners[i], direction) >= 0 && cross(direction, next_corner(i)) > 0))
      ++i;
    const Vec2 on_rim = bounds_[i] / dot(normals_[i], direction) * direction;
    return sectors_[i] + cross(hull_.corners[i], on_rim);
  }

  const Cover& cover_;
  const Points& boundary_;
  const SmallHull& hull_;
  std::array<Vec2, most_robots> normals_;  // of the sides of H, outward
  std::array<double, most_robots> bounds_{};
  std::array<double, most_robots + 1> sectors_{};  // twice the area before each corner
  double doubled_area_ = 0;
  Vec2 last_;  // the end of the last part outside, and the sector before it
  double before_last_ = 0;
  std::uint64_t visits_ = 0;  // of nodes and edges
};

Cover::Cover(const PolygonWithHoles& object, const Vec2& centre)
    : object_(object), centre_(centre), tree_(edges_of(object.boundary())), doubled_areas_{0} {
  for (const LineEnds& edge : edges_of(object.boundary()))
    doubled_areas_.push_back(doubled_areas_.back() + cross(edge.start - centre, edge.end - centre));
}

double Cover::of(const SmallHull& hull, std::uint64_t& steps) const {
  Sum sum(*this, hull);
  if (!sum.is_sound()) return 0;
  const double area = sum.area();
  steps += sum.steps();
  return std::clamp(area / object_.area(), 0.0, 1.0);
}

}  // namespace evenlift::balanced
