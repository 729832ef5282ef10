// Tables for users.
#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

using Row = std::vector<std::string>;

// Right-aligned columns, two spaces apart and as wide as necessary; the first row has the headings.
std::string table(const std::vector<Row>& rows);

}  // namespace evenlift::native
