#include "print/table.h"

#include <algorithm>

#include "evenlift/output/markup.h"

namespace evenlift::native {

std::string table(const std::vector<Row>& rows, const std::vector<std::string>& remarks) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], character_count(row[i]));
  std::string text;
  for (std::size_t at = 0; at < rows.size(); ++at) {
    const Row& row = rows[at];
    for (std::size_t i = 0; i < row.size(); ++i)
      text += "  " + std::string(widths[i] - character_count(row[i]), ' ') + row[i];
    if (at < remarks.size() && !remarks[at].empty()) text += "  " + remarks[at];
    text += "\n";
  }
  return text;
}

}  // namespace evenlift::native
