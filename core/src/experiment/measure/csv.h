// Writes and reads comma-separated values (RFC 4180) whose rows end in line feeds.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace evenlift::experiment::csv {

using Row = std::vector<std::string>;

// The text of a field, in quotes if necessary. O(bytes).
std::string field(std::string_view text);

// The text of a row, with its line feed. O(bytes).
std::string line(const Row& row);

// The rows of a text. Returns nothing if a quotation mark is still open at the end, if text follows
// a closing one, or if the last row does not end in a line feed. O(bytes).
std::optional<std::vector<Row>> read(std::string_view text);

}  // namespace evenlift::experiment::csv
