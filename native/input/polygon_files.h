// The polygons that paths name: files, and folders of them.
#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

struct PolygonFile {
  std::string set;   // the name of the folder given; single_files of a file given by itself
  std::string name;  // its path within that folder, or its file name; without the extension
  std::string path;
};

inline constexpr const char* single_files = "files";

// The files named, and of the folders named, with their sub-folders, all files that end in .txt,
// .wkt, .json, .geojson, .svg or .dxf, except index.txt, a folder's list of contents, and hidden
// ones. Each folder named is a set, and the files named are another. By set and name. Throws
// Failure for a path that is not there, a folder without polygons, two folders of one name, and two
// files of one name in a set.
std::vector<PolygonFile> find_polygon_files(const std::vector<std::string>& paths);

}  // namespace evenlift::native
