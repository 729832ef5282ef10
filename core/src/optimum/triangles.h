// The share of P's area that lies in each triangle with corners at C and at two chord ends.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"
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

}  // namespace evenlift::optimum
