// The order among candidates that tie for the best score (algorithm.md, Ties).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The first `count` of these candidates in the order of taking them while their scores continue to
// tie. Each time, keeps the candidates whose ratio ties with the best remaining ratio, then those
// whose length ties with the longest, and takes the first of them in candidate order. Ties are not
// transitive: when the best is taken, others may tie with the next best. So fixed classes of ties
// would be wrong. O(m log m) for m candidates left, and O(candidates).
std::vector<std::uint32_t> order_of_taking(const std::vector<Candidate>& candidates,
                                           std::vector<std::uint32_t> candidates_left,
                                           std::size_t count);

}  // namespace evenlift
