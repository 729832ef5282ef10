// Polygons of assets/polygons and results of tests/expected.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/formats.h"
#include "kit/catch.h"

namespace evenlift::corpus {

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  INFO(path.string());
  REQUIRE(file.good());
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  INFO(path.string());
  REQUIRE(file.flush().good());
}

inline std::filesystem::path polygons_folder() {
  return std::filesystem::path(EVENLIFT_ASSETS_DIR) / "polygons";
}

// Sorted, without ".txt" and index.txt.
inline std::vector<std::string> polygon_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(polygons_folder()))
    if (entry.path().extension() == ".txt" && entry.path().stem() != "index")
      names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

inline std::string polygon_text(const std::string& name) {
  return read_file(polygons_folder() / (name + ".txt"));
}

inline Document polygon(const std::string& name) {
  Result<Document> document = read_polygon(polygon_text(name));
  INFO(name);
  REQUIRE(document.ok());
  return *std::move(document);
}

}  // namespace evenlift::corpus
