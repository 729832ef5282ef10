// The name that a mistyped one may stand for.
#pragma once

#include <string_view>
#include <vector>

namespace evenlift {

// The first of the names with the fewest edits from the typed one: at most two, and fewer than half
// its bytes. Empty if there is none, and for more than 64 typed bytes. An edit inserts, removes or
// replaces a byte, or swaps two neighbours (the optimal string alignment distance). O(bytes of
// `typed` times bytes of `names`).
std::string_view closest_name(std::string_view typed, const std::vector<std::string_view>& names);

}  // namespace evenlift
