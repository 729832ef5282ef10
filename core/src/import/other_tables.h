// Recognizes tables that list other things than vertices.
#pragma once

#include <string_view>

namespace evenlift {

// A sentence that says what the rows of the table are, and what to do; null if the text is no table,
// or may be one of vertices. `beginning` may end within a line. O(beginning).
const char* refusal_of_other_table(std::string_view beginning);

}  // namespace evenlift
