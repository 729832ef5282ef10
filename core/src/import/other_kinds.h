// Kinds of tables and files that are not read.
#pragma once

#include <string_view>

namespace evenlift {

// --- Recognizes tables that list other things than vertices.

// A sentence that says what the rows of the table are, and what to do; null if the text is no table,
// or may be one of vertices. `beginning` may end within a line. O(beginning).
const char* refusal_of_other_table(std::string_view beginning);

// --- Recognizes known kinds of files that evenlift does not read.

// A sentence that names the kind of the file and says what the user can do instead; null if the
// file is of none of these kinds. The text may contain any bytes. Looks only at the first 65536
// bytes.
const char* refusal_of_other_kind(std::string_view text);

}  // namespace evenlift
