#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

using Row = std::vector<std::string>;

// Returns a table with right-aligned columns, two spaces apart and as wide as necessary. The first
// row has the headings. A row may have fewer cells; the remark of the same index, if any, follows.
std::string table(const std::vector<Row>& rows, const std::vector<std::string>& remarks = {});

}  // namespace evenlift::native
