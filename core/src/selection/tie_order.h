// The order of ties for the best score (algorithm.md, Ties).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The first `count` candidates in the order in which they are taken while their scores tie. Each
// step keeps the candidates whose ratio ties with the best one left, and of these the candidates
// whose length ties with the longest. It takes the first of them in candidate order. There are no
// fixed classes of ties, as ties are not transitive: once the best is taken, others may tie with
// the next. O(c + m log m) for c candidates, of which m are left.
std::vector<std::uint32_t> order_of_taking(const std::vector<Candidate>& candidates,
                                           std::vector<std::uint32_t> candidates_left,
                                           std::size_t count);

}  // namespace evenlift
