#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

using Row = std::vector<std::string>;

// Right-aligned columns, two spaces apart and as wide as necessary; the first row has the headings.
// A row may have fewer cells, and then the text at its place in `remarks` after them, if any.
std::string table(const std::vector<Row>& rows, const std::vector<std::string>& remarks = {});

}  // namespace evenlift::native
