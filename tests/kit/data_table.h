// Tables in tests/data: columns separated by tabs, texts as JSON strings, lines with # ignored.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/result.h"
#include "kit/catch.h"
#include "kit/json.h"

namespace evenlift::testing {

using Row = std::vector<std::string>;

// A missing file, an empty table or a row with a wrong number of columns fails the test.
inline std::vector<Row> read_table(const std::string& file, std::size_t columns) {
  std::ifstream stream(std::filesystem::path(EVENLIFT_TESTS_DIR) / "data" / file, std::ios::binary);
  REQUIRE(stream.good());
  std::vector<Row> rows;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    Row row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    INFO(file << ": " << line);
    REQUIRE(row.size() == columns);
    rows.push_back(std::move(row));
  }
  REQUIRE(!rows.empty());
  return rows;
}

inline std::string from_json_string(const std::string& cell) { return Json::parse(cell).text(); }

inline std::string name_of(ErrorCode code) {
  static const std::pair<ErrorCode, const char*> names[] = {
      {ErrorCode::too_few_vertices, "too_few_vertices"},
      {ErrorCode::too_many_vertices, "too_many_vertices"},
      {ErrorCode::bad_coordinate, "bad_coordinate"},
      {ErrorCode::bad_setting, "bad_setting"},
      {ErrorCode::bad_syntax, "bad_syntax"},
      {ErrorCode::unsupported, "unsupported"},
      {ErrorCode::text_too_long, "text_too_long"},
      {ErrorCode::bad_link, "bad_link"},
      {ErrorCode::bad_checksum, "bad_checksum"},
      {ErrorCode::unknown_version, "unknown_version"}};
  for (const auto& [known, name] : names) {
    if (known == code) return name;
  }
  return "another error";
}

// A line of printable text without a final full stop, shorter than a paragraph.
inline bool is_one_sentence(const std::string& message) {
  for (const char c : message) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') return false;
  }
  return message.size() > 8 && message.size() < 500 && message.back() != '.';
}

}  // namespace evenlift::testing
