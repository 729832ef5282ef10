#include "shapes/holed_polygons.h"

#include <algorithm>
#include <optional>
#include <set>

#include "evenlift/angles.h"
#include "evenlift/random.h"

namespace holed_polygons {
namespace {

using evenlift::Rng;
using oracle::Point;
using oracle::Ring;

/// A star with radii from `least` to 1; a convex ring if they are equal.
Ring ring_about_origin(Rng& rng) {
  const std::size_t n = 3 + rng.below(7);
  const double least = rng.below(2) == 0 ? 1 : 0.3;
  const double turn = rng.uniform();
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        2 * evenlift::pi * (static_cast<double>(i) + turn) / static_cast<double>(n);
    const double radius = least + (1 - least) * rng.uniform();
    ring.push_back({radius * evenlift::cosine(angle), radius * evenlift::sine(angle)});
  }
  if (rng.below(2) == 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

Ring placed(const Ring& ring, const Point& middle, double scale) {
  Ring result;
  for (const Point& p : ring)
    result.push_back({middle[0] + scale * p[0], middle[1] + scale * p[1]});
  return result;
}

struct Bounds {
  Point low, high;
  explicit Bounds(const Ring& ring) : low(ring.front()), high(ring.front()) {
    for (const Point& p : ring)
      for (const std::size_t k : {0u, 1u}) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
  }
  double size() const { return std::max(high[0] - low[0], high[1] - low[1]); }
};

/// About a random point, if it fits.
std::optional<Ring> hole_in(const Ring& outline, const std::vector<Ring>& holes, Rng& rng) {
  const Bounds bounds(outline);
  const double right = rng.uniform(), up = rng.uniform();
  const Point middle{bounds.low[0] + right * (bounds.high[0] - bounds.low[0]),
                     bounds.low[1] + up * (bounds.high[1] - bounds.low[1])};
  const Ring shape = ring_about_origin(rng);
  double scale = (0.05 + 0.3 * rng.uniform()) * bounds.size();
  const bool grows = rng.below(4) == 0;
  const auto fits = [&](double size) {
    return oracle::fits(outline, holes, placed(shape, middle, size));
  };
  const double least = 1e-3 * bounds.size();
  double too_large = scale;
  while (scale > least && !fits(scale)) {
    too_large = scale;
    scale /= 2;
  }
  if (scale <= least) return std::nullopt;
  for (int i = 0; grows && i < 30 && scale < too_large; ++i) {
    const double between = (scale + too_large) / 2;
    (fits(between) ? scale : too_large) = between;
  }
  return placed(shape, middle, scale);
}

/// Distinct points of a grid in any order.
Ring careless_ring(Rng& rng, std::size_t side) {
  const std::size_t n = 3 + rng.below(3);
  std::set<Point> seen;
  Ring ring;
  const double x0 = static_cast<double>(rng.below(side)), y0 = static_cast<double>(rng.below(side));
  while (ring.size() < n) {
    const double x = x0 + static_cast<double>(rng.below(4));
    const double y = y0 + static_cast<double>(rng.below(4));
    if (seen.insert({x, y}).second) ring.push_back({x, y});
  }
  return ring;
}

/// Of the grid, perhaps with a vertex on a side.
Ring rectangle(Rng& rng, std::size_t side) {
  const double x = static_cast<double>(rng.below(side)), y = static_cast<double>(rng.below(side));
  const double width = static_cast<double>(1 + rng.below(side)),
               height = static_cast<double>(1 + rng.below(side));
  Ring ring{{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
  if (rng.below(3) == 0) ring.insert(ring.begin() + 1, {x + width / 2, y});
  if (rng.below(2) == 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// About the middle of its vertices: often within the ring.
Ring halved(const Ring& ring) {
  Point sum{0, 0};
  for (const Point& p : ring) sum = {sum[0] + p[0], sum[1] + p[1]};
  const double n = static_cast<double>(ring.size());
  Ring result;
  for (const Point& p : ring) result.push_back({(p[0] + sum[0] / n) / 2, (p[1] + sum[1] / n) / 2});
  return result;
}

bool is_valid(const Ring& ring) { return oracle::refusal_of_ring(ring) == oracle::Refusal::none; }

}  // namespace

std::vector<Ring> holes_in(const Ring& outline, std::uint64_t seed, std::size_t most) {
  Rng rng(seed);
  std::vector<Ring> holes;
  for (std::size_t tries = 0; tries < 4 * most && holes.size() < most; ++tries)
    if (auto hole = hole_in(outline, holes, rng)) holes.push_back(*std::move(hole));
  return holes;
}

small_polygons::Case with_holes(small_polygons::Case c, std::uint64_t number) {
  c.problem.holes = holes_in(c.problem.vertices, number, 1 + number % 6);
  c.name += ", with " + std::to_string(c.problem.holes.size()) + " holes";
  return c;
}

small_polygons::Case make_case(std::uint64_t number) {
  return with_holes(small_polygons::make_plain_case(number), number);
}

std::vector<Ring> careless_rings(std::uint64_t number) {
  Rng rng(number);
  const std::size_t side = 4 + rng.below(6);
  const auto any = [&] {
    return rng.below(2) == 0 ? careless_ring(rng, side) : rectangle(rng, side);
  };
  std::vector<Ring> rings;
  const double end = static_cast<double>(side + 2);
  Ring outline = rng.below(2) == 0 ? any() : Ring{{-1, -1}, {end, -1}, {end, end}, {-1, end}};
  while (!is_valid(outline)) outline = any();
  rings.push_back(std::move(outline));
  const std::size_t holes = 1 + rng.below(3);
  while (rings.size() <= holes) {
    const std::uint64_t kind = rng.below(12);
    Ring ring = kind == 0 ? rings.front() : kind == 1 ? halved(rings.back()) : any();
    if (rng.below(8) != 0 && !is_valid(ring)) continue;
    rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace holed_polygons
