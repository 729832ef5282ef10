// The polygons that paths name: files, and folders of them.
#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

struct PolygonFile {
  std::string name;  // its path within the folder given, or its file name; without the extension
  std::string path;
};

// The files named, and of the folders named, with their sub-folders, all files that end in .txt,
// .wkt, .json or .geojson, but for index.txt, a folder's list of contents, and hidden ones. By
// name, and each name once. Throws Failure for a path that is not there, a folder without polygons,
// and two files of one name.
std::vector<PolygonFile> find_polygon_files(const std::vector<std::string>& paths);

}  // namespace evenlift::native
