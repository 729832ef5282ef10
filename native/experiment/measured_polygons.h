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
  std::string name;    // the file's, with the shape's number from 1 if it has several: "gear 2"
  std::string source;  // in errors: the file's path, and the shape's number
  Document document;
  std::optional<Failure> refused;  // why the file cannot be read; then no vertices
};

// Returns all shapes, in the order of the files. Reports omissions, and that all of several shapes
// are taken, on standard error, one per line. Throws Failure if two shapes of a set have the same
// name. O(bytes), plus O(k log k) for k shapes.
std::vector<MeasuredPolygon> read_polygons(const std::vector<PolygonFile>& files);

}  // namespace evenlift::native
