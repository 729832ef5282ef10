// Imports polygons with holes from SVG, DXF, columns of numbers, any GeoJSON, saved results, and
// the formats of formats.h. A text may contain many shapes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

inline constexpr std::size_t max_shapes = 10000;  // in one text

// Lengths are in the text's unit, above 0 and finite.
struct ImportOptions {
  // The greatest distance of a curve from the edges that replace it. By default it is, for each
  // shape, the greatest number of the form 1, 2 or 5 times a power of ten that does not exceed a
  // thousandth of the larger side of the box around the shape and its control points.
  std::optional<double> tolerance;
  // The greatest distance between joined ends. By default it is a thousandth of the drawing's
  // larger side.
  std::optional<double> join;
  // If true, longitudes and latitudes are converted to metres east and north of the middle of the
  // box around them, whether or not the text says that its coordinates are degrees.
  bool project = false;
  // If false, holes are left out, and a note says how many.
  bool holes = true;
};

struct ImportedShape {
  Document document;
  std::string name;  // the object's or its layer's, in UTF-8, no control characters; or empty
  std::string kind;  // in words, such as "rectangle"
  std::optional<double> tolerance;  // the greatest distance of edges from the curves that they
                                    // replace, also in holes; not set without curves
};

inline constexpr std::size_t most_open_points = 10000;

struct Import {
  std::string format;                 // in words, such as "DXF"
  std::vector<ImportedShape> shapes;  // one or more; in a drawing by area, largest first
  std::vector<std::string> notes;     // omissions and decisions, as sentences without full stops
  std::string unit;       // in words, such as "millimetres"; empty if the text names none
  bool doubtful = false;  // something larger than any shape was left out, so a person should choose
  // The lines of a drawing that do not close, in order. A line that would bring their points above
  // most_open_points is left out. Curves become edges within the default tolerance.
  std::vector<Points> left_open;
  bool has_settings = false;  // evenlift wrote the text, and the shape has its settings
  bool in_degrees = false;    // the coordinates are degrees by the text's own words, and stay so
};

// Reads a text. Its content determines the format:
//   formats.h  all that read_polygon() reads. If the text begins like the thesis's format, errors
//              are those of read_polygon()
//   SVG        polygon, polyline, path, line, rect, circle and ellipse, also in a nested svg and in
//              copies (use, symbol). Transforms (attribute or CSS) are applied; y is turned
//              upwards. A filled path is one shape or several, with the holes of its fill-rule. In
//              a switch, only the first child that all programs can read counts. The content of
//              defs, clipPath, mask, marker and pattern is left out, and so are shapes invisible by
//              display, visibility or opacity, or for lack of fill and stroke; if no shape has a
//              fill or a stroke, all are read. Properties may be in attributes, styles and style
//              sheets (selectors of a tag, a class, an id), also of parents. The share link in the
//              <metadata> of a picture that evenlift saved is opened. A size on paper, as in
//              width="210mm", gives the unit: mm, cm, in, and mm for pt, pc and Q. Coordinates are
//              scaled to this unit about the origin of user units: by viewBox and
//              preserveAspectRatio or, without a viewBox, with 96 user units to the inch. If a user
//              unit already is 1 mm, cm, m or in, that is the unit. Without a size on paper,
//              nothing is scaled. A curve that ends where it began is dropped if all its control
//              points are within a limit of that place: 1/200 of its outline's larger side or, if
//              larger, a given `tolerance`, but at most 1/10 of that side. All copies together take
//              at most 64 MiB
//   DXF        the model space of a DXF file in text form. LWPOLYLINE and POLYLINE (with bulges),
//              ELLIPSE and SPLINE are outlines if closed; a CIRCLE is always an outline. LINE, ARC
//              and open curves and polylines are pieces, joined as described below. A SPLINE is a
//              B-spline or NURBS curve of degree 1 to 10 with control points. INSERT draws its
//              block: scaled, mirrored, turned, in columns and rows, and in other blocks up to 32
//              deep, with at most 128 MiB for all copies together. A block's objects on layer 0 are
//              on the layer of the INSERT. Objects that are invisible, on the layer Defpoints or on
//              a layer that is off or frozen are left out. $INSUNITS gives the unit, which is also
//              the label of lengths if evenlift has that unit
//   columns    lines with x and y. The columns are separated by the first of these that the first
//              line with two numbers contains: tab, semicolon, bar, comma, space. Numbers may have
//              a decimal comma unless commas or spaces separate the columns. If commas do, numbers
//              in quotes may still have one, provided that one of the first lines has such a number
//              whose comma cannot separate thousands. A heading may name the columns, in upper or
//              lower case and perhaps with a unit: x (mm), X-Coordinate, POINT_X, Position X,
//              Easting, E, lon, and the same for y. x and y take precedence over easting and
//              northing, and these over longitude and latitude. Otherwise x and y are the first two
//              columns with numbers; columns that number the lines, stay the same, or have a
//              heading such as "Point No." or "Elevation" are passed over as long as two others
//              remain. If there are more than two columns with numbers, a note says which were
//              taken. Lines that begin with # are comments, but one before the first row may be the
//              heading. Up to 100 lines before the first row are headings; blank lines separate
//              shapes, and a line of words before a shape is its name. A row is refused if its
//              columns do not fit the heading or the first row, or if the first two rows begin with
//              the same word and this row with another. The two surfaces of an airfoil are joined
//   WKT        POLYGON and MULTIPOLYGON, also in a GEOMETRYCOLLECTION. There may be several of
//              these, each perhaps after `SRID=...;`. They may also be in a column of a table,
//              where another column may name or number the shapes
//   JSON       [[x, y], ...], [{"x": x, "y": y}, ...], or an array or an object of these; a point's
//              members are named like columns. Tuples and numbers such as "1.", as Python writes
//              them, are also read
//   Esri JSON  the rings of a geometry, a feature or a set of features. A ring inside another ring
//              of opposite direction is a hole of that ring
//   GeoJSON    the polygons in a FeatureCollection, MultiPolygon or GeometryCollection, named by
//              `name`, `title` or `id`
//   links      a share link alone
//   results    the JSON of `evenlift place --json`, of the page and of `link decode`, with all
//              settings, holes, cargo and the object's own centre of mass, unless this equals
//              the centroid in every bit
// Pieces of a drawing (in SVG, lines and open paths) are joined into outlines, whatever their
// order: within their layer, then across layers. Ends are joined within 1e-6 of the drawing's
// larger side and, where something stays open, in steps up to 1e-3; a note gives the gap. Pieces
// that lie on others count once, and dead ends are left out. Each undivided area that the remaining
// pieces enclose is a shape. An open path of an SVG that meets no other is closed by a straight
// edge. An outline without a fill that is directly inside a shape is a hole of that shape, and a
// note gives the number of such holes. Filled outlines are shapes, and so are outlines in a hole.
// Outlines that touch or cross are separate shapes.
//
// A vertex that equals the preceding one is dropped, with a note unless the text is a drawing; the
// thesis's format, links and results keep such vertices. The last vertex is also dropped if it
// equals the first or, in a drawing, if their distance is at most 1/100000 of the shape's larger
// side.
//
// Coordinates that are degrees by the text's own words (GeoJSON without another reference system,
// columns of longitude and latitude, reference systems of EWKT and Esri JSON) stay as they are,
// with a note. With `project`, a note gives the origin, with at most four decimals, and the
// greatest error of a width if that is at least 0.1 %. It is an error to convert coordinates that
// cannot be degrees, reach beyond latitude 85 or span the 180th meridian, or the coordinates of a
// result or a link.
//
// Meshes, STEP, IGES, G-code and other known kinds are refused by name. object_of()
// (polygon_with_holes.h) checks the geometry. The result depends only on the text and the options,
// on every platform. The limits are max_text_bytes, max_vertices for all shapes together,
// max_shapes (in a drawing, holes included) and, outside drawings, max_holes for each shape.
// O(bytes + points), plus O(n log n) to join the n ends of a drawing's pieces, and O(k^2) for its k
// outlines.
Result<Import> read_shapes(std::string_view text, const ImportOptions& options = {});

// Robots that already stand. `capacities` has one entry for each place if any robot has a capacity;
// otherwise it is empty.
struct SupportFile {
  Points places;
  // Where the robots touch the boundary: from JSON, one for each place, which is the place itself
  // if the text gives no contact; otherwise empty.
  Points contacts;
  std::vector<std::optional<double>> capacities;
  LengthUnit unit = LengthUnit::none;  // by the headings; metres for poses in YAML (ROS 2)
};

// Reads the places from a table whose first line names the columns x, y and perhaps capacity (also
// "Cap.", "SWL", "WLL" or "max load"), from the JSON of a result (robots[].at) or of robot poses,
// from [[x, y], ...], or from robot poses as YAML. The limits are max_text_bytes and most_supports.
// O(bytes).
Result<SupportFile> read_support_file(std::string_view text);

// Removes the holes and returns the note about them, or an empty text. O(vertices).
std::string leave_out_holes(std::vector<ImportedShape>& shapes);

// Describes a shape, as in `"base plate", rectangle, 4 vertices, 2 holes, 120 x 80`. O(n).
std::string describe(const ImportedShape& shape);

}  // namespace evenlift
