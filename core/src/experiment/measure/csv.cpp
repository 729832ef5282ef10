#include "experiment/measure/csv.h"

namespace evenlift::experiment::csv {

std::string field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string line(const Row& row) {
  std::string out;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) out += ',';
    out += field(row[i]);
  }
  return out + '\n';
}

std::optional<std::vector<Row>> read(std::string_view text) {
  std::vector<Row> rows;
  Row row;
  for (std::size_t at = 0; at < text.size();) {
    std::string value;
    if (text[at] == '"') {
      for (++at;; ++at) {
        if (at >= text.size()) return std::nullopt;
        if (text[at] == '"' && text.substr(at + 1, 1) != "\"") break;
        if (text[at] == '"') ++at;
        value += text[at];
      }
      ++at;
    } else {
      const std::size_t end = text.find_first_of(",\n", at);
      if (end == std::string_view::npos) return std::nullopt;
      value = text.substr(at, end - at);
      at = end;
    }
    if (at >= text.size() || (text[at] != ',' && text[at] != '\n')) return std::nullopt;
    row.push_back(std::move(value));
    if (text[at++] == ',') {
      if (at == text.size()) return std::nullopt;
      continue;
    }
    rows.push_back(std::move(row));
    row.clear();
  }
  return rows;
}

}  // namespace evenlift::experiment::csv
