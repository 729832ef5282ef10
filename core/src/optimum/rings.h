// The share of P's area that lies in each triangle with corners at C and at two chord ends.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/optimum.h"
#include "evenlift/polygon_with_holes.h"

namespace evenlift::optimum {

// The shares of P in the triangles of K chords in candidate order. End i < K is the right end of
// chord i, and end K + i is its left end. So ends are numbered in order about C.
class Triangles {
 public:
  // O(n K^2).
  Triangles(const PolygonWithHoles& object, const Vec2& centre,
            const std::vector<Candidate>& candidates);

  std::uint32_t chords() const { return chords_; }
  std::uint32_t ends() const { return 2 * chords_; }
  // The end `steps` places after `end`, cyclically. Both are less than ends().
  std::uint32_t after(std::uint32_t end, std::uint32_t steps) const {
    const std::uint32_t at = end + steps;
    return at < ends() ? at : at - ends();
  }
  std::uint32_t chord_of(std::uint32_t end) const { return end % chords_; }

  // The share of P in the triangle of C, the end `from`, and the end `steps` places later,
  // cyclically. `steps` is at most chords(), so the angle at C is at most 180 degrees.
  double share(std::uint32_t from, std::uint32_t steps) const {
    return shares_[from * (chords_ + std::size_t{1}) + steps];
  }

 private:
  std::uint32_t chords_;
  std::vector<double> shares_;
};

// --- The best rings of ends (algorithm.md, The optimum).

// A ring's ends, and the share of P's area in the triangles of C with successive ends.
struct Ring {
  double share = 0;
  std::vector<std::uint32_t> ends;  // in order about C, except from best_ring_by_sides()
};

// The best ring of at most `most` ends of any chords. All three functions call `stop` before each
// first end or first chord that they try, and return nullopt if it returns true. O(K^3 most).
std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop);

// The best ring that has both ends of some chord, and ends of at most `teams` chords. Any other
// ring of `teams` chords has at most `teams` ends, so best_ring() covers it. O(K^4 teams).
std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop);

// A ring whose share is at least that of best_ring_of_chords(). It has both ends of one chord, and
// up to `teams` - 1 other ends on each side of this chord. The two sides together may use more than
// `teams` - 1 other chords. O(K^3 teams).
std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop);

}  // namespace evenlift::optimum
