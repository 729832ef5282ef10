// Tables for people.
#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

using Row = std::vector<std::string>;

// Columns two spaces apart, as wide as they need, to the right; the first row are headings.
std::string table(const std::vector<Row>& rows);

}  // namespace evenlift::native
