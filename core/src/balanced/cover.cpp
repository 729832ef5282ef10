#include "balanced/search.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "exact/sorted_indices.h"

namespace evenlift::balanced {
namespace {

using Few = std::array<Vec2, most_robots>;

std::size_t sort_positions(const std::vector<LiftingPoint>& robots, const Vec2& centre,
                           Few& sorted) {
  std::size_t number = 0;
  for (const LiftingPoint& robot : robots) {
    const Vec2 position = robot.position - centre;
    std::size_t at = number++;
    for (; at > 0 && lexicographically_before(position, sorted[at - 1]); --at)
      sorted[at] = sorted[at - 1];
    sorted[at] = position;
  }
  return number;
}

// A chain of left turns through points in sorted or reverse order.
class Chain {
 public:
  void append(const Vec2& p) {
    while (size_ >= 2 && !turns_left(p)) --size_;
    points_[size_++] = p;
  }

  // Leaves out the last point.
  void add_to(SmallHull& hull) const {
    for (std::size_t i = 0; i + 1 < size_; ++i) hull.corners[hull.size++] = points_[i];
  }

 private:
  bool turns_left(const Vec2& p) const {
    const Vec2 &a = points_[size_ - 2], &b = points_[size_ - 1];
    return cross(b - a, p - a) > 0;
  }

  Few points_;
  std::size_t size_ = 0;
};

}  // namespace

SmallHull small_hull(const std::vector<LiftingPoint>& robots, const Vec2& centre) {
  assert(robots.size() <= most_robots);
  Few sorted;
  const std::size_t number = sort_positions(robots, centre, sorted);
  SmallHull hull;
  Chain lower, upper;
  for (std::size_t i = 0; i < number; ++i) lower.append(sorted[i]);
  for (std::size_t i = number; i-- > 0;) upper.append(sorted[i]);
  lower.add_to(hull);
  upper.add_to(hull);
  for (std::size_t i = 2; i < hull.size; ++i)
    hull.area += cross(hull.corners[i - 1] - hull.corners[0], hull.corners[i] - hull.corners[0]);
  hull.area /= 2;
  return hull;
}

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

namespace {

constexpr double rounding = 1e-9;  // of places in cells, and of shares

double area_within(const Points& part, double from, double to) {
  Points cut;
  clip(
      part, [&](const Vec2& p) { return p.x - from; }, cut);
  Points cell;
  clip(
      cut, [&](const Vec2& p) { return to - p.x; }, cell);
  return cell.size() < 3 ? 0 : std::fabs(signed_area(cell));
}

Points row_of(const Points& polygon, double from, double to) {
  Points cut, row;
  clip(
      polygon, [&](const Vec2& p) { return p.y - from; }, cut);
  clip(
      cut, [&](const Vec2& p) { return to - p.y; }, row);
  return row;
}

}  // namespace

CoarseCover::CoarseCover(const PolygonWithHoles& object, const Vec2& centre) {
  const Box box = bounding_box(object.outline().vertices());
  low_ = box.low - centre;
  scale_ = static_cast<double>(cells) * Vec2(1 / box.size().x, 1 / box.size().y);
  Points in_cells;
  for (const Vec2& v : object.boundary())
    in_cells.push_back(componentwise_product(v - centre - low_, scale_));
  const double whole = object.area() * scale_.x * scale_.y;
  for (std::size_t row = 0; row < cells; ++row) {
    const auto y = static_cast<double>(row);
    const Points part = row_of(in_cells, y, y + 1);
    for (std::size_t column = 0; column < cells; ++column) {
      const auto x = static_cast<double>(column);
      before_[row][column + 1] = before_[row][column] + area_within(part, x, x + 1) / whole;
    }
  }
}

std::size_t CoarseCover::cell_of(double place) {
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(cells - 1)));
}

// Widens each of `rows` to include the part of the side a b of H in that row.
void CoarseCover::widen(Rows& rows, const Vec2& a, const Vec2& b) {
  const Vec2 &lower = a.y <= b.y ? a : b, &upper = a.y <= b.y ? b : a;
  const double height = upper.y - lower.y;
  const double slope = height > 0 ? (upper.x - lower.x) / height : 0;
  const auto widen_row = [&](std::size_t row, double x) {
    rows[row].first = std::min(rows[row].first, x);
    rows[row].last = std::max(rows[row].last, x);
  };
  const std::size_t bottom = cell_of(lower.y - rounding), top = cell_of(upper.y + rounding);
  widen_row(bottom, lower.x);
  for (std::size_t row = bottom; row < top; ++row) {
    const double x = lower.x + slope * (static_cast<double>(row + 1) - lower.y);
    const double within = std::clamp(x, std::min(a.x, b.x), std::max(a.x, b.x));
    widen_row(row, within);
    widen_row(row + 1, within);
  }
  widen_row(top, upper.x);
}

double CoarseCover::most(const SmallHull& hull) const {
  Rows rows;
  const auto corner = [&](std::size_t i) -> Vec2 {
    return componentwise_product(hull.corners[i] - low_, scale_);
  };
  if (hull.size == 0) return 0;
  Vec2 last = corner(hull.size - 1);
  for (std::size_t i = 0; i < hull.size; ++i) {
    const Vec2 here = corner(i);
    widen(rows, last, here);
    last = here;
  }
  double share = rounding;
  for (std::size_t row = 0; row < cells; ++row) {
    if (rows[row].first > rows[row].last) continue;
    const std::size_t first = cell_of(rows[row].first - rounding),
                      end = cell_of(rows[row].last + rounding) + 1;
    share += before_[row][end] - before_[row][first];
  }
  return share;
}

}  // namespace evenlift::balanced
