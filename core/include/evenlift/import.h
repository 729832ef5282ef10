// Imports polygons with holes from drawings and tables: SVG, DXF, columns of numbers, any GeoJSON,
// saved results, and the formats of formats.h. A text may contain many shapes, each offered
// separately.
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
  // above 0 and finite. The default depends on the shape: it is the greatest number of the form 1,
  // 2 or 5 times a power of ten that is at most a thousandth of the larger side of the box around
  // the shape and its control points.
  std::optional<double> tolerance;
  // The greatest distance between two ends of lines or curves that are joined, in the text's unit:
  // above 0 and finite. By default up to a thousandth of the drawing's larger side.
  std::optional<double> join;
  // Converts longitudes and latitudes in degrees to metres east and north of the middle of the box
  // around them, in every text whose coordinates can be degrees, whatever the text says.
  bool project = false;
  // Keeps the holes of shapes. Otherwise a note says how many are left out.
  bool holes = true;
};

struct ImportedShape {
  Document document;
  std::string name;  // of the object or its layer, UTF-8 without control characters; may be empty
  std::string kind;  // in words, such as "rectangle"
  std::optional<double> tolerance;  // if it or a hole had curves: greatest distance of edges from
                                    // them
};

inline constexpr std::size_t most_open_points = 10000;

struct Import {
  std::string format;                 // in words, such as "DXF"
  std::vector<ImportedShape> shapes;  // one or more; those of a drawing by area, largest first
  std::vector<std::string> notes;     // omissions and decisions, as sentences without full stops
  std::string unit;       // in words, such as "millimetres"; empty if the text names none
  bool doubtful = false;  // what was left out is larger than any shape, so a person should choose
  // The lines of a drawing that do not close, in order, so that a picture can show them. A line
  // that would bring them above most_open_points points in all is left out. Curves have the default
  // tolerance.
  std::vector<Points> left_open;
  bool has_settings = false;  // evenlift wrote the text, and the shape has its settings
  bool in_degrees = false;    // the text says so, and its coordinates were not converted
};

// Reads a text. The content determines the format:
//   formats.h  all that read_polygon() reads. If a text begins like the thesis's format, its errors
//              are those of read_polygon()
//   SVG        polygon, polyline, path, line, rect, circle and ellipse, also in an svg within the
//              svg, and copies of them (use, symbol). Transforms, from the attribute or CSS, are
//              applied, and y is turned upwards. A path that is filled is one shape or several,
//              with the holes that its fill-rule leaves (from an attribute, a style, a style sheet
//              or a parent). Of a switch, only the first child that all programs can read counts.
//              The content of defs, clipPath, mask, marker and pattern is left out. Shapes that are
//              invisible by display, visibility or opacity, or for lack of fill and stroke, are
//              left out, whether an attribute, a style, a style sheet (selectors of a tag, a class,
//              an id) or a parent says so. If no shape has fill or stroke, all are read. A picture
//              that evenlift saved has its share link in <metadata>; the link is opened. A size on
//              paper, as in width="210mm" height="297mm", gives the unit: mm, cm, in, and mm for
//              pt, pc and Q. Coordinates are scaled to this unit about the origin of user units: by
//              viewBox and preserveAspectRatio or, without a viewBox, with 96 user units to the
//              inch. They stay as they are if a user unit already is 1 mm, cm, m or in, which is
//              then the unit. Without a size on paper they are user units. A curve that ends where
//              it began is dropped if its control points are no farther from there than 1/200 of
//              its outline's larger side or, if `tolerance` is given and larger, than `tolerance`,
//              but never more than 1/10 of that side. Bounded by 64 MiB for all copies together
//   DXF        as text: the model space. LWPOLYLINE and POLYLINE (with bulges), ELLIPSE and SPLINE
//              are outlines if they are closed, and CIRCLE always is one. LINE, ARC and every
//              LWPOLYLINE, POLYLINE, ELLIPSE or SPLINE that is open are pieces, which are joined as
//              described below. A SPLINE is any B-spline or NURBS curve of degree 1 to 10 with
//              control points. INSERT draws its block: scaled, mirrored, turned, in columns and
//              rows, and within other blocks up to 32 deep; the text of all copies together has at
//              most 128 MiB. A block's objects on layer 0 are on the layer of the INSERT. Objects
//              that are invisible, on a layer that is off or frozen, or on Defpoints are left out.
//              $INSUNITS gives the unit; if evenlift has this unit, it is also the label of lengths
//   columns    x and y in lines, separated by tabs, semicolons, bars, commas or spaces: by the
//              first of these, in this order, that the first line with two numbers contains.
//              Numbers may have a decimal comma unless commas or spaces separate the columns. If
//              commas separate them, numbers in quotes may still have a decimal comma, provided
//              that one of the first lines has such a number in which the comma cannot separate
//              thousands. A heading may name the columns, in upper or lower case and perhaps with a
//              unit: x (mm), X-Coordinate, POINT_X, Position X, Easting, E, lon, and the same for
//              y. x and y take precedence over easting and northing, and these over longitude and
//              latitude. Otherwise x and y are the first two columns with numbers. Columns that
//              number the lines, stay the same, or have a heading such as "Point No." or
//              "Elevation" are passed over as long as two others remain. If there are more than two
//              columns with numbers, a note says which were taken. Lines that begin with # are
//              comments; before the first row, such a line may be the heading. Up to 100 lines
//              before the first row are headings; blank lines separate shapes, and a line of words
//              before a shape is its name. A row is refused if its columns do not fit the heading
//              or the first row, or if the first two rows begin with the same word and this row
//              begins with another. The two surfaces of an airfoil are joined
//   WKT        POLYGON, MULTIPOLYGON and those in a GEOMETRYCOLLECTION, one geometry or several,
//              each perhaps preceded by `SRID=...;`. The geometries may also be a column of a
//              table; another column may then give the names or numbers of the shapes. Rings after
//              the first are holes
//   JSON       [[x, y], ...], or [{"x": x, "y": y}, ...], or an array or an object of these; the
//              names of a point's members are those of columns. Tuples and numbers such as "1.", as
//              Python writes them, are also read
//   Esri JSON  the rings of a geometry, a feature or a set of features. A ring inside another ring
//              of opposite direction is a hole of that ring
//   GeoJSON    the polygons in a FeatureCollection, MultiPolygon or GeometryCollection, named by
//              `name`, `title` or `id`. Rings after the first are holes
//   links      a share link alone
//   results    the JSON of `evenlift place --json`, of the page and of `link decode`, with all
//              settings, holes and cargo. The object's own centre of mass is read. If it equals the
//              centroid in every bit, the shape uses its centroid
// Pieces of a drawing (in SVG, lines and open paths) are joined into outlines: within their layer,
// then across layers. Ends are joined within 1e-6 of the drawing's larger side and, where something
// stays open, in coarser steps up to 1e-3; a note gives the gap. Pieces that lie on others count
// once, and dead ends are left out. Each undivided area that the remaining pieces enclose is a
// shape. The order of the pieces does not matter. An open path of an SVG that meets no other is
// closed by a straight edge. An outline without a fill that is directly inside a shape is a hole of
// it, and a note counts these holes. A filled one is a shape wherever it lies, and so is any
// outline in a hole. Outlines that touch or cross are separate shapes.
//
// A vertex that equals the preceding vertex is dropped, with a note unless the text is a drawing;
// the thesis's format, links and results keep theirs. The last vertex is also dropped if it equals
// the first or, in a drawing, if the two are within 1/100000 of the shape's larger side.
//
// Coordinates that are degrees by the text's own words (GeoJSON without another reference system,
// columns of longitude and latitude, the reference systems of EWKT and Esri JSON) stay as they are,
// with a note, unless ImportOptions::project converts them. With `project`, a note gives the
// origin, with at most four decimals, and the greatest error of a width if that error is 0.1 % or
// more. It is an error to convert coordinates that cannot be degrees, reach beyond latitude 85 or
// span the 180th meridian, or those of a result or a link.
//
// Files of other kinds that evenlift recognizes (meshes, STEP, IGES, G-code) are refused, and the
// error names the kind. The geometry is not checked; object_of() (polygon_with_holes.h) does that.
// The result depends only on the text and the options, on every platform. Bounded by
// max_text_bytes, max_vertices for all shapes together, max_shapes (in a drawing, holes included)
// and, outside drawings, max_holes for each shape. O(bytes + points), plus O(n log n) to join the n
// ends of a drawing's pieces, and O(k^2) for k outlines of a drawing.
Result<Import> read_shapes(std::string_view text, const ImportOptions& options = {});

// The places of robots that already stand. If any robot has a capacity, there are as many
// capacities as places, each a number or nothing; otherwise there are none.
struct SupportFile {
  Points places;
  Points contacts;  // where they touch the boundary, if a result says so; as many, or none
  std::vector<std::optional<double>> capacities;
  LengthUnit unit = LengthUnit::none;  // as the headings say; robot poses for ROS 2 are in metres
};

// Reads the places from a table whose first line names the columns x and y, and perhaps capacity
// (also "Cap.", "SWL", "WLL" or "max load");
// from the JSON of a result (robots[].at) or of robot poses; from [[x, y], ...]; or from robot
// poses as YAML. Bounded by max_text_bytes and most_supports. O(bytes).
Result<SupportFile> read_support_file(std::string_view text);

// Leaves out the holes of shapes. Returns the note about them; empty if there are none.
// O(vertices).
std::string leave_out_holes(std::vector<ImportedShape>& shapes);

// Describes a shape by its name, kind, vertices, holes if it has some, and size, as in `"base
// plate", rectangle, 4 vertices, 2 holes, 120 x 80`. O(n).
std::string describe(const ImportedShape& shape);

}  // namespace evenlift
