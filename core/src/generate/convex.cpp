// Irregular convex polygons by Valtr's method (P. Valtr, Probability that n random points are in
// convex position, 1995): draw the steps of two closed walks, pair them at random as x and y of
// vectors, and sort these by direction.
#include <algorithm>
#include <cassert>
#include <utility>

#include "generate/families.h"

namespace evenlift::families {
namespace {

using Vector = GridPoint;

// n whole numbers with the sum 0, the positive ones with the sum `extent`: the steps of a walk from
// 0 to the extent and back over n places drawn at random.
std::vector<std::int64_t> closed_walk(std::size_t n, std::int64_t extent, Rng& rng) {
  std::vector<double> places;
  for (std::size_t i = 0; i < n; ++i) places.push_back(rng.uniform());
  std::sort(places.begin(), places.end());
  const double first = places.front();
  const double stretch = static_cast<double>(extent) / (places.back() - first);

  std::vector<std::int64_t> steps;
  std::int64_t there = 0, back = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const std::int64_t place = nearest((places[i] - first) * stretch);
    std::int64_t& last = rng.below(2) == 0 ? there : back;
    steps.push_back(&last == &there ? place - last : last - place);
    last = place;
  }
  steps.push_back(extent - there);
  steps.push_back(back - extent);
  return steps;
}

void shuffle(std::vector<std::int64_t>& values, Rng& rng) {
  for (std::size_t i = values.size(); i > 1; --i)
    std::swap(values[i - 1], values[static_cast<std::size_t>(rng.below(i))]);
}

bool is_zero(const Vector& v) { return v.x == 0 && v.y == 0; }
bool lower_half(const Vector& v) { return v.y < 0 || (v.y == 0 && v.x < 0); }
std::int64_t cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

// Counter-clockwise from the direction of x. Zero vectors, which have none, come first.
bool before(const Vector& a, const Vector& b) {
  if (is_zero(a) || is_zero(b)) return is_zero(a) && !is_zero(b);
  if (lower_half(a) != lower_half(b)) return lower_half(b);
  return cross(a, b) > 0;
}
bool same_direction(const Vector& a, const Vector& b) { return !before(a, b) && !before(b, a); }

// Sorts by direction until no two agree, so that the outline is strictly convex. If two agree, one
// gains a small vector and a random one loses it, which keeps the sum. The grid has many more than
// n directions, so few repeats remain after each round.
void make_directions_distinct(std::vector<Vector>& vectors, std::int64_t reach, Rng& rng) {
  for (bool repeats = true; repeats;) {
    repeats = false;
    // Equal directions are sorted by coordinates, so that the result does not depend on the sort.
    std::sort(vectors.begin(), vectors.end(), [](const Vector& a, const Vector& b) {
      if (!same_direction(a, b)) return before(a, b);
      return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      const bool repeated = i > 0 && same_direction(vectors[i - 1], vectors[i]);
      if (!repeated && !is_zero(vectors[i])) continue;
      repeats = true;
      const auto partner = static_cast<std::size_t>(rng.below(vectors.size()));
      const auto width = static_cast<std::uint64_t>(2 * reach + 1);
      const std::int64_t dx = static_cast<std::int64_t>(rng.below(width)) - reach;
      const std::int64_t dy = static_cast<std::int64_t>(rng.below(width)) - reach;
      vectors[i].x += dx;
      vectors[i].y += dy;
      vectors[partner].x -= dx;
      vectors[partner].y -= dy;
    }
  }
}

std::vector<GridPoint> draw_outline(std::size_t n, std::int64_t extent, Rng& rng) {
  assert(n >= 3);
  const std::vector<std::int64_t> xs = closed_walk(n, extent, rng);
  std::vector<std::int64_t> ys = closed_walk(n, extent, rng);
  shuffle(ys, rng);
  std::vector<Vector> vectors;
  for (std::size_t i = 0; i < n; ++i) vectors.push_back({xs[i], ys[i]});
  make_directions_distinct(vectors,
                           std::max<std::int64_t>(1, extent / static_cast<std::int64_t>(n)), rng);

  std::vector<GridPoint> outline;
  GridPoint at, least;
  for (const Vector& v : vectors) {
    outline.push_back(at);
    at = {at.x + v.x, at.y + v.y};
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
  }
  for (GridPoint& p : outline) p = {p.x - least.x, p.y - least.y};
  return outline;
}

}  // namespace

GridPolygon convex(std::size_t n, Rng& rng) {
  GridPolygon polygon;
  // Fine enough for n directions, and coarse enough that the turn at a vertex, at least one square
  // unit, exceeds any change from rounding to doubles.
  polygon.decimals = n <= 1000 ? 3 : n <= 100000 ? 5 : 6;
  const std::int64_t extent = nearest(1000 * units(polygon.decimals));
  const double square = static_cast<double>(extent) * static_cast<double>(extent);
  // Few vertices may give a sliver: draw again.
  for (int attempt = 0; attempt < 20; ++attempt) {
    polygon.vertices = draw_outline(n, extent, rng);
    if (doubled_area(polygon.vertices) > 0.5 * square) break;
  }
  return polygon;
}

}  // namespace evenlift::families
