// The families of polygons that generate() offers. Their vertices are on an integer grid, where
// turns and comparisons are exact; generate() converts them to decimal coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/random.h"

namespace evenlift::families {

// A point in units of 10^-decimals.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const GridPoint&) const = default;
};

struct GridPolygon {
  std::vector<GridPoint> vertices;  // simple, either orientation
  int decimals = 3;                 // 0 .. 9
};

// Positive if c is to the left of the line from a to b. Exact for coordinates up to 1e9 in size.
inline std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Twice the signed area, with rounding errors; positive for counter-clockwise vertices.
double doubled_area(const std::vector<GridPoint>& vertices);

// 10^decimals, exactly.
double units(int decimals);

// The nearest integer. Halves round away from zero, so that symmetric shapes stay symmetric.
std::int64_t nearest(double value);

GridPolygon regular(std::size_t n);           // O(n)
GridPolygon convex(std::size_t n, Rng& rng);  // expected O(n log n)
GridPolygon star(std::size_t n, Rng& rng);    // O(n)
GridPolygon comb(std::size_t n, Rng& rng);    // O(n)
GridPolygon spiral(std::size_t n, Rng& rng);  // O(n)
GridPolygon random(std::size_t n, Rng& rng);  // expected O(n)

}  // namespace evenlift::families
