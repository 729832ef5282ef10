#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

struct PolygonFile {
  std::string set;   // the name of the given folder; single_files for a file given directly
  std::string name;  // its path in that folder, or its file name, without the extension
  std::string path;
};

inline constexpr const char* single_files = "files";

// Finds the given files and, in the given folders and their sub-folders, all files whose names end
// in .txt, .wkt, .json, .geojson, .svg or .dxf. Ignores hidden files and folders, and index.txt,
// which is a list of contents. Each given folder is a set, and the given files together are another
// set. The result is sorted by set and name. Throws Failure for a missing path, a folder without
// polygon files, two sets with the same name, and two files of a set with the same name.
std::vector<PolygonFile> find_polygon_files(const std::vector<std::string>& paths);

}  // namespace evenlift::native
