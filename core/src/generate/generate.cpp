// Irregular convex polygons by Valtr's method (P. Valtr, Probability that n random points are in
// convex position, 1995): draw the steps of two closed walks, pair them at random as x and y of
// vectors, and sort these by direction.
#include "evenlift/generate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "evenlift/angles.h"
#include "evenlift/document.h"
#include "evenlift/wording.h"
#include "exact/sorted_indices.h"
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
    sort_items(vectors, [](const Vector& a, const Vector& b) {
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

namespace evenlift {

namespace families {

double units(int decimals) {
  double power = 1;
  for (int i = 0; i < decimals; ++i) power *= 10;
  return power;
}

std::int64_t nearest(double value) {
  const double size = std::floor(std::abs(value) + 0.5);
  return static_cast<std::int64_t>(value < 0 ? -size : size);
}

double doubled_area(const std::vector<GridPoint>& vertices) {
  const auto x = [&](std::size_t i) { return static_cast<double>(vertices[i].x - vertices[0].x); };
  const auto y = [&](std::size_t i) { return static_cast<double>(vertices[i].y - vertices[0].y); };
  double sum = 0;
  for (std::size_t i = 2; i < vertices.size(); ++i) sum += x(i - 1) * y(i) - y(i - 1) * x(i);
  return sum;
}

namespace {

constexpr double radius = 500;  // of the circle about (500, 500) that regular, star and spiral fill

GridPoint on_grid(double x, double y, int decimals) {
  return {nearest(x * units(decimals)), nearest(y * units(decimals))};
}

// The point at an angle about (500, 500).
GridPoint polar(double distance, double angle_rad, int decimals) {
  GridPoint p = on_grid(distance * cosine(angle_rad), distance * sine(angle_rad), decimals);
  const GridPoint middle = on_grid(radius, radius, decimals);
  p.x += middle.x;
  p.y += middle.y;
  return p;
}

// Three decimals for files that people read; for larger n, enough to keep n vertices apart.
int readable_decimals(std::size_t n) { return n <= 1000 ? 3 : 6; }

}  // namespace

// The first edge is at the bottom. Rounding must stay well below the turn at a vertex, about
// (2 pi)^3 r^2 / n^3.
GridPolygon regular(std::size_t n) {
  GridPolygon polygon;
  polygon.decimals = n <= 1000 ? 3 : n <= 10000 ? 5 : n <= 100000 ? 7 : 9;
  const auto count = static_cast<std::int64_t>(n);
  for (std::int64_t i = 0; i < count; ++i) {
    // The angle from straight down, in half steps, is in (-n, n], so that mirrored vertices have
    // mirrored coordinates.
    const std::int64_t half_steps = 2 * i - 1 > count ? 2 * i - 1 - 2 * count : 2 * i - 1;
    const double angle = pi * static_cast<double>(half_steps) / static_cast<double>(count);
    GridPoint p = on_grid(radius * sine(angle), -radius * cosine(angle), polygon.decimals);
    const GridPoint middle = on_grid(radius, radius, polygon.decimals);
    polygon.vertices.push_back({p.x + middle.x, p.y + middle.y});
  }
  return polygon;
}

// Draws one direction in each n-th of the circle, less a margin. So they stay in order after
// rounding, and neighbours are less than 180 degrees apart.
GridPolygon star(std::size_t n, Rng& rng) {
  GridPolygon polygon;
  polygon.decimals = readable_decimals(n);
  const double margin = n < 5 ? 0.3 : 0.1;
  for (std::size_t i = 0; i < n; ++i) {
    const double place = static_cast<double>(i) + margin + (1 - 2 * margin) * rng.uniform();
    const double distance = radius * (0.3 + 0.7 * rng.uniform());
    polygon.vertices.push_back(
        polar(distance, 2 * pi * place / static_cast<double>(n), polygon.decimals));
  }
  return polygon;
}

// A flat base with teeth on both sides of a block in the middle. All slanted edges cross the height
// of C, so every edge on the left faces every edge on the right. The outline above the base runs
// strictly leftwards, so it is simple.
GridPolygon comb(std::size_t n, Rng& rng) {
  GridPolygon polygon;
  polygon.decimals = readable_decimals(n);
  const auto add = [&](double x, double y) {
    polygon.vertices.push_back(on_grid(x, y, polygon.decimals));
  };
  const auto valley = [&] { return 120 + 100 * rng.uniform(); };
  const auto tip = [&] { return 860 + 140 * rng.uniform(); };

  // Valleys and tips alternate outwards from the block. The last one is at the end of the base.
  struct Tooth {
    double distance, height;
  };
  const auto teeth = [&](std::size_t count) {
    std::vector<Tooth> row;
    const double step = 455.0 / static_cast<double>(count);
    for (std::size_t i = 1; i <= count; ++i) {
      const double jitter = i == count ? 0 : 0.6 * rng.uniform() - 0.3;
      const double height = i % 2 == 1 ? valley() : tip();
      row.push_back({45 + step * (static_cast<double>(i) + jitter), height});
    }
    return row;
  };

  const std::size_t in_teeth = n - 4;
  const std::vector<Tooth> right = teeth((in_teeth + 1) / 2);
  const std::vector<Tooth> left = teeth(in_teeth / 2);
  add(0, 0);
  add(1000, 0);
  for (std::size_t i = right.size(); i-- > 0;) add(500 + right[i].distance, right[i].height);
  const double block_right = tip();
  const double block_left = tip();
  add(545, block_right);
  add(455, block_left);
  for (const Tooth& tooth : left) add(500 - tooth.distance, tooth.height);
  return polygon;
}

// A strip wound about (500, 500) along r = start + pitch * turns. The vertices of all turns lie on
// the same rays. Edges cross neighbouring rays in the same order, so none meet. There are at most
// six turns; more vertices make the spiral rounder.
GridPolygon spiral(std::size_t n, Rng& rng) {
  GridPolygon polygon;
  polygon.decimals = readable_decimals(n);
  const std::size_t steps = n / 2 - 1;
  const double wished_turns = std::min(6.0, 0.35 * std::sqrt(static_cast<double>(steps)));
  const auto rays = std::max<std::size_t>(
      5, static_cast<std::size_t>(std::round(static_cast<double>(steps) / wished_turns)));
  const double turns = static_cast<double>(steps) / static_cast<double>(rays);

  const double width = 0.35 + 0.25 * rng.uniform();  // of the strip, in pitches
  const double first_angle = 2 * pi * rng.uniform();
  const bool mirrored = rng.below(2) == 1;
  const double pitch = radius / (0.5 + turns + width);
  const auto point = [&](double step, double across) {
    const double turned = step / static_cast<double>(rays);
    const double angle = first_angle + 2 * pi * turned;
    return polar(pitch * (0.5 + turned + width * across), mirrored ? pi - angle : angle,
                 polygon.decimals);
  };

  for (std::size_t i = 0; i <= steps; ++i)
    polygon.vertices.push_back(point(static_cast<double>(i), 1));
  if (n % 2 == 1)
    polygon.vertices.push_back(point(static_cast<double>(steps) + 0.5, 0.5));  // a pointed end
  for (std::size_t i = steps + 1; i-- > 0;)
    polygon.vertices.push_back(point(static_cast<double>(i), 0));
  return polygon;
}

}  // namespace families

namespace {

struct FamilyInfo {
  Family family;
  std::string_view name;
  std::size_t fewest;
};
constexpr FamilyInfo family_table[] = {
    {Family::regular, "regular", 3}, {Family::convex, "convex", 3}, {Family::star, "star", 3},
    {Family::comb, "comb", 8},       {Family::spiral, "spiral", 8}, {Family::random, "random", 3},
};

constexpr bool families_are_in_order() {
  for (std::size_t i = 0; i < std::size(family_table); ++i)
    if (family_table[i].family != static_cast<Family>(i) ||
        all_families[i] != family_table[i].family)
      return false;
  return std::size(family_table) == std::size(all_families);
}
static_assert(families_are_in_order(), "info() finds a family by its number");

const FamilyInfo& info(Family family) { return family_table[static_cast<std::size_t>(family)]; }

families::GridPolygon draw(Family family, std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  switch (family) {
    case Family::regular:
      return families::regular(n);
    case Family::convex:
      return families::convex(n, rng);
    case Family::star:
      return families::star(n, rng);
    case Family::comb:
      return families::comb(n, rng);
    case Family::spiral:
      return families::spiral(n, rng);
    case Family::random:
      return families::random(n, rng);
  }
  return {};
}

InputError bad_size(std::string message) { return bad_setting("n", std::move(message)); }

}  // namespace

std::string_view name(Family family) { return info(family).name; }

std::optional<Family> family_from_name(std::string_view name) {
  for (const FamilyInfo& entry : family_table)
    if (entry.name == name) return entry.family;
  return std::nullopt;
}

Result<Points> generate(Family family, std::size_t n, std::uint64_t seed) {
  if (n < info(family).fewest)
    return bad_size(
        say("a polygon of the family {family} has at least {fewest} vertices, not {number}",
            {"\"" + std::string(name(family)) + "\"", info(family).fewest, n}));
  if (n > max_vertices)
    return bad_size(
        say("at most {most} vertices can be generated, not {number}", {max_vertices, n}));

  families::GridPolygon polygon = draw(family, n, seed);
  if (families::doubled_area(polygon.vertices) < 0)
    std::reverse(polygon.vertices.begin(), polygon.vertices.end());
  Points points;
  points.reserve(n);
  // The quotient of two whole numbers is the double nearest to the decimal number, and is printed
  // as that number.
  const double unit = families::units(polygon.decimals);
  for (const families::GridPoint& p : polygon.vertices)
    points.emplace_back(static_cast<double>(p.x) / unit, static_cast<double>(p.y) / unit);
  return points;
}

}  // namespace evenlift
