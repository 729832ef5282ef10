// The order among candidates that tie for the best score (algorithm.md, Ties).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The first `count` of these candidates in the order in which they are taken if their scores go on
// to tie: each time those stay whose ratio ties with the best ratio that is left, of them those
// whose length ties with the longest, and the first of them in candidate order is taken. Ties are
// not transitive: when the best is taken, others may tie with the next best. So classes of ties,
// made once, would not do. O(m log m) for m candidates left, and O(candidates).
std::vector<std::uint32_t> order_of_taking(const std::vector<Candidate>& candidates,
                                           std::vector<std::uint32_t> candidates_left,
                                           std::size_t count);

}  // namespace evenlift
