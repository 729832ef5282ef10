// The name for which a mistyped name may stand.
#pragma once

#include <string_view>
#include <vector>

namespace evenlift {

// The first of the names with the fewest edits from the typed text. There may be at most two edits,
// and fewer than half the bytes of the text. The result is empty if there is no such name, or if
// the text has more than 64 bytes. An edit inserts, removes or replaces a byte, or swaps two
// neighbours (the optimal string alignment distance). O(bytes of `typed` times bytes of `names`).
std::string_view closest_name(std::string_view typed, const std::vector<std::string_view>& names);

}  // namespace evenlift
