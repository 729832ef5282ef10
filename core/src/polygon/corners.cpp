#include "polygon/corners.h"

#include <algorithm>
#include <limits>

namespace evenlift {
// Begins after a vertex that turns; every polygon has one.
Corners::Corners(const Polygon& polygon)
    : polygon_(polygon),
      before_(polygon.size(), none),
      after_(polygon.size(), none),
      is_corner_(polygon.size()),
      begin_(polygon.size()),
      end_(polygon.size()),
      back_(polygon.size(), std::numeric_limits<double>::infinity()),
      on_(polygon.size(), std::numeric_limits<double>::infinity()) {
  std::size_t first = 0;
  while (polygon.turn(first) == Turn::straight) ++first;
  std::vector<std::uint32_t> ends, run;
  std::size_t begin = first;
  do {
    std::size_t end = begin;
    run.clear();
    do {
      run.push_back(static_cast<std::uint32_t>(end));
      end = polygon.next(end);
    } while (polygon.turn(end) == Turn::straight);
    is_corner_[end] = polygon.is_corner(end);
    ends.push_back(static_cast<std::uint32_t>(end));
    for (const std::uint32_t edge : run) {
      begin_[edge] = static_cast<std::uint32_t>(begin);
      end_[edge] = static_cast<std::uint32_t>(end);
      if (polygon.turn(begin) == Turn::convex) before_[edge] = begin_[edge];
      if (polygon.turn(end) == Turn::convex) after_[edge] = end_[edge];
    }
    begin = end;
  } while (begin != first);

  // Each way along the outline twice, since a corner may be beyond where it begins.
  const auto pass = [&](std::vector<double>& way, std::uint32_t at, std::uint32_t beyond) {
    if (is_corner_[at])
      way[at] = 0;
    else if (!polygon.is_notch(at))
      way[at] = length(polygon.vertex(beyond) - polygon.vertex(at)) + way[beyond];
  };
  const std::size_t runs = ends.size();
  for (std::size_t k = 2 * runs; k-- > 0;) pass(on_, ends[k % runs], ends[(k + 1) % runs]);
  for (std::size_t k = 0; k < 2 * runs; ++k) pass(back_, ends[(k + 1) % runs], ends[k % runs]);
}

double Corners::distance_to(const Vec2& point, std::uint32_t edge) const {
  const std::uint32_t begin = begin_[edge], end = end_[edge];
  return std::min(length(polygon_.vertex(begin) - point) + back_[begin],
                  length(polygon_.vertex(end) - point) + on_[end]);
}

}  // namespace evenlift
