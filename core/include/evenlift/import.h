// Imports polygons from drawings and tables: SVG, DXF, columns of numbers, any GeoJSON, saved
// results, and the formats of formats.h. A text may contain many shapes, each offered separately.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

inline constexpr std::size_t max_shapes = 10000;  // of one text

struct ImportOptions {
  // The greatest distance of a curve from the straight edges that replace it, in the text's unit:
  // above 0 and finite. The default depends on the shape: the greatest number with the single digit
  // 1, 2 or 5 that is at most a thousandth of the larger side of the box around the shape and its
  // control points.
  std::optional<double> tolerance;
};

struct ImportedShape {
  Document document;
  std::string name;  // of the object or its layer, UTF-8 without control characters; may be empty
  std::string kind;  // in words, such as "rectangle"
  std::optional<double> tolerance;  // if it had curves: greatest distance of edges from them
};

struct Import {
  std::string format;                 // in words, such as "DXF"
  std::vector<ImportedShape> shapes;  // in the order of the text; one or more
  std::vector<std::string> notes;     // omissions and decisions, as sentences without full stops
  std::string unit;           // in words, such as "millimetres"; empty if the text names none
  bool has_settings = false;  // the shape has the text's settings: evenlift wrote it
};

// Reads a text. The content determines the format:
//   formats.h  all that read_polygon() reads. If a text begins like the thesis's format or WKT, its
//              errors are those of read_polygon()
//   SVG        polygon, polyline, path, rect, circle and ellipse with their transforms, in user
//              units and with y turned upwards. Each outline of a path is a shape. Hidden elements
//              and the content of defs, symbol, clipPath, mask, marker and pattern are not drawn.
//              A picture that evenlift saved has its share link in <metadata>; the link is opened.
//              width, height and viewBox give the unit of the user units, as in width="210mm"
//              viewBox="0 0 210 297"
//   DXF        with text codes, the model space: closed LWPOLYLINE and POLYLINE with bulges,
//              CIRCLE, and closed ELLIPSE and SPLINE. LINE, ARC and open ones of these in one
//              layer are chained where their ends are no farther apart than 1/100000 of the
//              drawing's larger side, and count if the chain closes. $INSUNITS gives the unit, as
//              a label if evenlift has it
//   columns    x and y in lines, separated by tabs, semicolons, bars, commas or spaces: by the
//              first of these, in this order, that the first line with a number contains.
//              Decimals may have a comma unless commas or spaces separate the columns. A heading
//              may name the columns x and y, and their unit: x (mm), y (mm); otherwise the first
//              two columns with numbers count. Lines that begin with # are comments, and blank
//              lines separate shapes
//   JSON       [[x, y], ...], or [{"x": x, "y": y}, ...], or an array of these
//   GeoJSON    the outer rings of the polygons in a FeatureCollection, MultiPolygon or
//              GeometryCollection, named by `name`, `title` or `id`
//   links      a share link alone
//   results    the JSON of `evenlift place --json`, of the page and of `link decode`, with all
//              settings. A centre of mass that equals the centroid in every bit is the centroid
// A vertex that equals the preceding vertex is dropped from drawings. A last vertex that repeats
// the first is also dropped: if it is equal, or in drawings within 1/100000 of the shape's larger
// side. Nothing else is checked; Polygon::create does that. The result depends only on the text and
// numbers, on every platform. Bounded by max_text_bytes, max_shapes, and max_vertices for all
// shapes together. O(bytes + points), and O(n log n) for chains.
Result<Import> read_shapes(std::string_view text, const ImportOptions& options = {});

// The places of robots that already stand, with their capacities if any robot has one: as many, each
// a number or nothing.
struct SupportFile {
  Points places;
  Points contacts;  // where they touch the boundary, if a result says so; as many, or none
  std::vector<std::optional<double>> capacities;
  LengthUnit unit = LengthUnit::none;  // as the headings say; robot poses for ROS 2 are in metres
};

// Reads the places from a table whose first line names the columns x and y, and perhaps capacity
// (also "Cap.", "SWL", "WLL" or "max load");
// from the JSON of a result (robots[].at) or of robot poses; from [[x, y], ...]; or from robot poses
// as YAML. Bounded by max_text_bytes and most_supports. O(bytes).
Result<SupportFile> read_support_file(std::string_view text);

// Describes a shape by its name, kind, vertices and size, as in `"base plate", rectangle, 4
// vertices, 120 x 80`. O(n).
std::string describe(const ImportedShape& shape);

}  // namespace evenlift
