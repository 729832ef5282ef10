#include "polygon/corners.h"

namespace evenlift {

// Begins after a vertex that turns; every polygon has one.
Corners::Corners(const Polygon& polygon)
    : before_(polygon.size(), none), after_(polygon.size(), none), is_corner_(polygon.size()) {
  std::size_t first = 0;
  while (polygon.turn(first) == Turn::straight) ++first;
  std::vector<std::size_t> run;
  std::size_t begin = first;
  do {
    std::size_t end = begin;
    run.clear();
    do {
      run.push_back(end);
      end = polygon.next(end);
    } while (polygon.turn(end) == Turn::straight);
    is_corner_[end] = polygon.is_corner(end);
    for (const std::size_t edge : run) {
      if (polygon.turn(begin) == Turn::convex) before_[edge] = static_cast<std::uint32_t>(begin);
      if (polygon.turn(end) == Turn::convex) after_[edge] = static_cast<std::uint32_t>(end);
    }
    begin = end;
  } while (begin != first);
}

}  // namespace evenlift
