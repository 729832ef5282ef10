// Lines and arcs that are drawn one by one, put together to closed outlines.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "curves/outline.h"

namespace evenlift {

struct Chain {
  Outline outline;
  std::size_t parts;  // how many lines and arcs it has
  bool closed;        // its end is its start
};

// Takes the parts one after another: each chain begins with the first that is left, and goes on
// with the part whose end is nearest to the chain's end and no farther from it than `near` (of
// equally near ones the first), turned round if need be, until it is back where it began or nothing
// follows. The ends that meet become one point. O(n log n).
std::vector<Chain> chained(const std::vector<Outline>& parts, double near);

}  // namespace evenlift
