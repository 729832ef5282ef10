#include "tools/shorter_way.h"

#include <algorithm>

#include "evenlift/wording.h"

namespace evenlift::view {
namespace {

// In the order of the list of vertices.
Points forward_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to) {
  const std::size_t n = vertices.size();
  const Vec2& start = vertices[from.edge];
  const bool ahead = length(to.position - start) >= length(from.position - start);
  Points way{from.position};
  if (from.edge != to.edge || !ahead) {
    std::size_t edge = from.edge;
    do {
      edge = (edge + 1) % n;
      way.push_back(vertices[edge]);
    } while (edge != to.edge);
  }
  way.push_back(to.position);
  return way;
}

double length_of(const Points& way) {
  double sum = 0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += length(way[i] - way[i - 1]);
  return sum;
}

}  // namespace

Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to) {
  Points there = forward_way(vertices, from, to), back = forward_way(vertices, to, from);
  if (length_of(there) <= length_of(back)) return there;
  std::reverse(back.begin(), back.end());
  return back;
}

std::string closed_in_words(const Placement& placement, std::size_t robot) {
  return say(placement.settings.method == Method::balanced
                 ? "Robot {robot} cannot go there: no two neighbours could keep all loads equal."
                 : "Robot {robot} cannot go there: other robots are in the way.",
             {robot + 1});
}

}  // namespace evenlift::view
