// Drawings and tables that people have, as polygons: SVG, DXF, columns of numbers, GeoJSON of any
// kind, and the results that evenlift saves, besides the formats of formats.h. A text may hold many
// shapes; each is offered by itself.
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
  // How far a curve may be from the straight edges that replace it, in the text's unit: above 0 and
  // finite. Without it each shape has its own: the number with one digit, 1, 2 or 5, that is next
  // below a thousandth of the larger side of the box around the shape and its control points.
  std::optional<double> tolerance;
};

struct ImportedShape {
  Document document;
  std::string name;  // of the object or its layer, UTF-8 without control characters; may be empty
  std::string kind;  // in words, such as "rectangle"
  std::optional<double> tolerance;  // if it had curves: how far its edges may be from them
};

struct Import {
  std::string format;                 // in words, such as "DXF"
  std::vector<ImportedShape> shapes;  // in the order of the text; one or more
  std::vector<std::string> notes;  // what was left out or decided, as sentences without full stops
  std::string unit;           // in words, such as "millimetres", or empty if the text names none
  bool has_settings = false;  // the shape's settings are the text's: evenlift wrote it
};

// Reads a text. Its content shows in which format it is:
//   formats.h  what read_polygon() reads. A text that begins like the thesis's format or like WKT is
//              refused with its words
//   SVG        polygon, polyline, path, rect, circle and ellipse with their transforms, in user units
//              and y turned upwards. Each outline of a path is a shape. What is hidden, or in defs,
//              symbol, clipPath, mask, marker or pattern, is not drawn. A picture that evenlift saved
//              has its share link in <metadata>, and that is opened. The unit is the one that width,
//              height and viewBox make of the user units, as width="210mm" viewBox="0 0 210 297" do
//   DXF        with text codes, its model space: closed LWPOLYLINE and POLYLINE with bulges, CIRCLE
//              and closed ELLIPSE and SPLINE; and LINE, ARC and open ones of these of one layer, if
//              they close, chained where their ends are no farther apart than 1/100000 of the
//              drawing's larger side. $INSUNITS gives the unit, as a label where evenlift has it
//   columns    x and y in lines, with tabs, semicolons, bars, commas or spaces between them: the first
//              of these, in this order, that the first line with a number has. Decimals may have a
//              comma unless commas or spaces are between the columns. A heading may name the columns x
//              and y, and their unit: x (mm), y (mm); without, the first two with numbers count. Lines
//              that begin with # are comments, and blank lines part shapes
//   JSON       [[x, y], ...], or [{"x": x, "y": y}, ...], or an array of such
//   GeoJSON    the polygons of a FeatureCollection, MultiPolygon or GeometryCollection, named by
//              `name`, `title` or `id`; of each its outer ring
//   links      a share link by itself
//   results    the JSON of `evenlift place --json`, of the page and of `link decode`, with all
//              settings. A centre of mass that equals the centroid in every bit is the centroid
// Vertices that repeat the one before are dropped from drawings, and so is a last vertex that
// repeats the first: exactly, or in drawings within 1/100000 of the shape's larger side. Nothing
// else is checked; Polygon::create does that. Text and numbers alone decide the result, on every
// platform. Bounded by max_text_bytes, max_shapes, and max_vertices for all shapes together.
// O(bytes + points), and O(n log n) for chains.
Result<Import> read_shapes(std::string_view text, const ImportOptions& options = {});

// A shape in words: its name, its kind, its vertices and its size, as in `"base plate", rectangle,
// 4 vertices, 120 x 80`. O(n).
std::string describe(const ImportedShape& shape);

}  // namespace evenlift
