// Files of other kinds, which are refused by name.
#pragma once

#include <string_view>

namespace evenlift {

// A sentence that says which kind of file the text is and what to do instead; null if the text is
// of no such kind. The text may contain any bytes. O(the first lines).
const char* refusal_of_other_kind(std::string_view text);

}  // namespace evenlift
