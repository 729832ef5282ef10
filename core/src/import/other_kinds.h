// Files of other kinds, which are refused by name.
#pragma once

#include <string_view>

namespace evenlift {

// What the text is and what to do instead, in one sentence; null for other texts. The text may
// contain any bytes. O(the first lines).
const char* refusal_of_other_kind(std::string_view text);

}  // namespace evenlift
