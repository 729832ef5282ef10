// Recognizes known kinds of files, and of tables, that evenlift does not read.
#pragma once

#include <string_view>

namespace evenlift {

// A sentence that names the kind of the file or table and says what the user can do instead; null if
// it is of none of these kinds. The text may contain any bytes. Looks only at the first 65536
// bytes.
const char* refusal_of_other_kind(std::string_view text);

}  // namespace evenlift
