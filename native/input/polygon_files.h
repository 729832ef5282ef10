// The polygons in files and folders.
#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

struct PolygonFile {
  std::string set;   // the name of the given folder; single_files for a file given by itself
  std::string name;  // its path within that folder, or its file name; without the extension
  std::string path;
};

inline constexpr const char* single_files = "files";

// The given files, and all files in the given folders and their sub-folders that end in .txt, .wkt,
// .json, .geojson, .svg or .dxf, except hidden ones and index.txt, a folder's list of contents.
// Each given folder is a set, and the given files are another. Sorted by set and name. Throws
// Failure for a missing path, a folder without polygons, two folders with the same name, and two
// files with the same name in a set.
std::vector<PolygonFile> find_polygon_files(const std::vector<std::string>& paths);

}  // namespace evenlift::native
