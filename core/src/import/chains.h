// Joins lines and arcs that are drawn one by one into closed outlines.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "curves/outline.h"

namespace evenlift {

struct Chain {
  Outline outline;
  std::size_t parts;  // the number of its lines and arcs
  bool closed;        // its end is its start
};

// Takes the parts in order. Each chain begins with the first unused part. It continues with the
// part whose end is nearest to the chain's end and at most `near` away (in a tie, the first part),
// reversed if necessary, until it returns to its start or no part follows. Ends that meet become
// one point. O(n log n).
std::vector<Chain> chained(const std::vector<Outline>& parts, double near);

}  // namespace evenlift
