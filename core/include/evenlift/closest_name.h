// Finds the name that a mistyped text probably means.
#pragma once

#include <string_view>
#include <vector>

namespace evenlift {

// The name that is the fewest edits away from the typed text; of several, the first. At most two
// edits are allowed, and fewer than half the number of bytes in the text. The result is empty if no
// name is near enough, or if the text exceeds 64 bytes. An edit inserts, removes or replaces a
// byte, or swaps two neighbours (optimal string alignment). O(bytes of `typed` times bytes of
// `names`).
std::string_view closest_name(std::string_view typed, const std::vector<std::string_view>& names);

}  // namespace evenlift
