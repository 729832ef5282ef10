// Finds the points near a place or a segment by means of a square grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

class PointGrid {
 public:
  // The points must outlive the grid. `cell` is the side of a cell and must be above 0. O(n log n).
  PointGrid(const Points& points, double cell) : points_(points), cell_(cell) {
    low_ = bounding_box(points).low;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [x, y] = cell_of(points[i]);
      entries_.push_back({x, y, i});
    }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
      return std::tie(a.x, a.y, a.point) < std::tie(b.x, b.y, b.point);
    });
  }

  // Visits the points i within `near` of `at`, including a point at `at` itself. It looks at no
  // more than most_visited points in each column of cells, so it may miss some points where very
  // many are near. O(log n + visits) if `near` is about `cell`.
  template <class Visit>
  void for_each_near(const Vec2& at, double near, Visit visit) const {
    const auto [x0, y0] = cell_of(at - Vec2(near, near));
    const auto [x1, y1] = cell_of(at + Vec2(near, near));
    for (std::int64_t x = x0; x <= x1; ++x)
      for_each_in_column(x, y0, y1, most_visited, [&](std::size_t i) {
        if (length(points_[i] - at) <= near) visit(i);
      });
  }

  // Visits the points i within `near` of the segment from a to b, and perhaps others close to the
  // segment. O(c log n + visits) for c columns of cells.
  template <class Visit>
  void for_each_along(const Vec2& a, const Vec2& b, double near, Visit visit) const {
    const Vec2 &left = a.x <= b.x ? a : b, &right = a.x <= b.x ? b : a;
    const std::int64_t x0 = cell_of(left - Vec2(near, near)).first,
                       x1 = cell_of(right + Vec2(near, near)).first;
    const double width = right.x - left.x;
    for (std::int64_t x = x0; x <= x1; ++x) {
      // The column's range of x, widened by `near`, and the segment's y at a given x.
      const double from = low_.x + static_cast<double>(x) * cell_ - near,
                   to = from + cell_ + 2 * near;
      const auto height = [&](double at) {
        const double part = width > 0 ? std::clamp((at - left.x) / width, 0.0, 1.0) : 0;
        return left.y + part * (right.y - left.y);
      };
      double low = height(from), high = width > 0 ? height(to) : right.y;
      if (low > high) std::swap(low, high);
      const std::int64_t y0 = cell_of({from, low - near}).second,
                         y1 = cell_of({from, high + near}).second;
      for_each_in_column(x, y0, y1, points_.size(), visit);
    }
  }

 private:
  static constexpr std::size_t most_visited = 256;  // points in a column of cells
  struct Entry {
    std::int64_t x, y;
    std::size_t point;
  };

  std::pair<std::int64_t, std::int64_t> cell_of(const Vec2& point) const {
    constexpr double most = 1e15;
    const auto whole = [&](double value) {
      return static_cast<std::int64_t>(std::clamp(std::floor(value / cell_), -most, most));
    };
    return {whole(point.x - low_.x), whole(point.y - low_.y)};
  }

  template <class Visit>
  void for_each_in_column(std::int64_t x, std::int64_t y0, std::int64_t y1, std::size_t most,
                          Visit visit) const {
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair(x, y0),
                                  [](const Entry& e, const auto& cell) {
                                    return std::tie(e.x, e.y) < std::tie(cell.first, cell.second);
                                  });
    for (std::size_t seen = 0;
         entry != entries_.end() && entry->x == x && entry->y <= y1 && seen < most; ++entry, ++seen)
      visit(entry->point);
  }

  const Points& points_;
  double cell_;
  Vec2 low_;
  std::vector<Entry> entries_;
};

}  // namespace evenlift
