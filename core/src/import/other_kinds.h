// Files of other kinds, which are refused by their name.
#pragma once

#include <string_view>

namespace evenlift {

// What the text is, and what to do instead, in one sentence; null if it is none of the kinds known
// here. The text may contain any bytes. O(the first lines).
const char* refusal_of_other_kind(std::string_view text);

}  // namespace evenlift
