#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/document.h"
#include "input/failure.h"
#include "input/polygon_files.h"

namespace evenlift::native {

struct MeasuredPolygon {
  std::string set;
  std::string name;    // PolygonFile::name, and the shape's number if there are several: "gear 2"
  std::string source;  // names the shape in errors: the file's path, and the shape's number
  Document document;
  std::optional<Failure> refused;  // why the file cannot be read; the document is then empty
};

// Returns all shapes, in the order of the files. Prints notes on standard error, one per line: what
// it leaves out, and which files have several shapes. Throws Failure if two shapes of a set have
// the same name. O(bytes + k log k) for k shapes.
std::vector<MeasuredPolygon> read_polygons(const std::vector<PolygonFile>& files);

}  // namespace evenlift::native
