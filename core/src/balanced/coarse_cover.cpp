#include "balanced/coarse_cover.h"

#include <algorithm>
#include <cmath>

#include "evenlift/hull.h"
#include "evenlift/plane.h"

namespace evenlift::balanced {
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
