// Imports polygons with holes from SVG, DXF, columns of numbers, WKT, JSON of several kinds, share
// links, saved results, and the thesis's format. A text may contain many shapes.
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
  // The greatest distance of a curve from the edges that replace it. By default it is chosen for
  // each outline: a thousandth of the larger side of the box around the outline and its control
  // points, rounded down to 1, 2 or 5 times a power of ten.
  std::optional<double> tolerance;
  // The greatest gap between two line ends that are joined. By default it is a thousandth of the
  // larger side of the box around the drawing.
  std::optional<double> join;
  // If true, longitudes and latitudes are converted to metres east and north of the middle of the
  // box around them, whether or not the text says that its coordinates are degrees.
  bool project = false;
  // If false, holes are left out, and a note says how many.
  bool holes = true;
};

struct ImportedShape {
  Document document;
  // As UTF-8 without control characters: of several parts of a drawing, the text in the part or, if
  // there is none, the nearest one beside it; otherwise the name of the object, its block (unless all
  // parts are in one copy of it) or its layer, or empty.
  std::string name;
  std::string kind;  // in words, such as "rectangle"
  // The greatest distance of edges from the curves that they replace, also in holes; not set if
  // there are no curves.
  std::optional<double> tolerance;
  // Whether it is the sheet or border of a drawing rather than a part on it. Sheets come last.
  bool sheet = false;
  // The smallest shape around it, in a hole or on the sheet, by its index among the import's shapes.
  std::optional<std::size_t> within = {};
  std::size_t order = 0;  // its place in the text among the shapes, from 0
};

inline constexpr std::size_t most_open_points = 10000;

struct Import {
  std::string format;                 // in words, such as "DXF"
  std::vector<ImportedShape> shapes;  // one or more; in a drawing sorted by area, largest first
  std::vector<std::string> notes;     // omissions and decisions, as sentences without full stops
  std::string unit;  // in words, such as "millimetres"; empty if the text names none
  // Whether a person should confirm even a single shape, because the box around some connected open
  // lines has a larger area than the box around the largest shape.
  bool doubtful = false;
  // A drawing's lines that do not close, in the drawing's order. A line that would bring the total
  // number of points above most_open_points is left out. Curves become edges within the default
  // tolerance.
  std::vector<Points> left_open;
  bool has_settings = false;  // the text is evenlift's own and gives the shape's settings
  bool in_degrees = false;  // the coordinates are degrees, as the text says, and were not converted
};

// Reads a text. Its content determines the format:
//   thesis     the thesis's format, by read_thesis() (formats.h)
//   SVG        polygon, polyline, path, line, rect, circle and ellipse, also in a nested `svg` and
//              in copies (`use`, `symbol`). Transforms (attribute or CSS) are applied; y is turned
//              upwards. A filled path is one shape or several, and its fill-rule decides which of
//              its parts are holes. Only one child of a `switch` counts: the first that needs no
//              extension and is in English or in no stated language. The content of `defs`,
//              `clipPath`, `mask`, `marker` and `pattern` is left out. So are shapes that are
//              invisible because of `display`, `visibility` or `opacity`, or because they have
//              neither fill nor stroke; if no shape has a fill or a stroke, all are read.
//              Properties come from attributes, styles and style sheets (selectors of a tag, a
//              class or an id), and from parents. If evenlift saved the picture, only the share
//              link in its <metadata> is read. Only a size on paper, as in width="210mm", gives a
//              unit. If a user unit is then 1 mm, 1 cm, 1 m or 1 inch, this is the unit, and
//              nothing is scaled. Otherwise the unit is that of the size (mm if the size is in pt,
//              pc or Q), and coordinates are scaled to it about the origin of user units. The size
//              of a user unit follows from viewBox and preserveAspectRatio; without a viewBox, 96
//              user units are an inch. A curve that ends where it began is dropped if none of its
//              control points is farther from that place than a limit. The limit is 1/200 of the
//              larger side of the box around the curve's outline and its control points, or
//              `tolerance` if that is larger, but at most 1/10 of this side. All copies together
//              take at most 64 MiB
//   DXF        the model space of a DXF file in text form. LWPOLYLINE and POLYLINE (with bulges),
//              ELLIPSE and SPLINE are outlines if closed; a CIRCLE is always an outline. LINE, ARC
//              and open curves and polylines are pieces, joined as described below. A SPLINE is a
//              B-spline or NURBS curve of degree 1 to 10 with control points. INSERT draws its
//              block scaled, mirrored, turned and repeated in columns and rows. Blocks may insert
//              other blocks, up to 32 deep; all copies together take at most 128 MiB. A block's
//              objects on layer 0 count as objects on the layer of the INSERT. Objects that are
//              invisible, on the layer Defpoints or on a layer that is off or frozen are left out.
//              $INSUNITS gives the unit. Lengths are shown in it if it is a LengthUnit
//   columns    lines with x and y. The columns are separated by a tab, semicolon, bar, comma or
//              space: the first of these that the first line with two numbers contains. Numbers may
//              have a decimal comma if a tab, semicolon or bar separates the columns. If a comma
//              does, only numbers in quotes may have one, and only if one of them in the first 200
//              lines has a comma that cannot separate thousands. A heading may name the columns, in
//              upper or lower case and perhaps with a unit: x (mm), X-Coordinate, POINT_X, Position
//              X, Easting, E, lon, and similar names for y. x and y take precedence over easting
//              and northing, and these over longitude and latitude. Without such a heading, x and y
//              are the first two columns with numbers. As long as two others remain, a column is
//              passed over if it numbers the lines or shapes, has the same number in every line, or
//              has a heading such as "Point No." or "Elevation". If there are more than two columns
//              with numbers, a note says which were taken. Lines that begin with # are comments,
//              but one before the first row may be the heading. At most 99 other lines may precede
//              the first row. Blank lines separate shapes, and so does a column that numbers or
//              names them; a line of words before a shape is its name. A row is refused if its
//              columns do not fit the heading or the first row. It is also refused if the first two
//              rows begin with the same word and this row begins with another. The two surfaces of
//              an airfoil are joined
//   WKT        POLYGON and MULTIPOLYGON, also in a GEOMETRYCOLLECTION. A text may contain several
//              geometries, each perhaps after `SRID=...;`. Geometries may also be in a column of a
//              table, where another column may name or number the shapes
//   JSON       [[x, y], ...], [{"x": x, "y": y}, ...], or an array or an object of such arrays. The
//              members of a point are named like columns. Tuples and numbers such as "1.", as
//              Python writes them, are also read
//   Esri JSON  the rings of a geometry, a feature or a set of features. A ring inside a ring of the
//              opposite direction is a hole of the outer one
//   GeoJSON    the polygons in a FeatureCollection, MultiPolygon or GeometryCollection, named by
//              `name`, `title` or `id`
//   links      a share link and nothing else
//   results    the JSON of `evenlift place --json`, of the page and of `link decode`, with all
//              settings, holes and cargo. The object's own centre of mass is also read, unless it
//              equals the centroid in every bit
// The pieces of a drawing (in SVG, lines and open paths), in whatever order, are joined into
// outlines, first within their layer, then across layers. Ends are joined if their distance is at
// most 1e-6 of the drawing's larger side. Where pieces stay open, this limit grows in steps up to
// 1e-3, or up to `join` if given; a note gives the greatest gap if it exceeds 1.5e-5 of that side.
// Parts of pieces that lie on other pieces count once, and dead ends are left out. Each undivided
// area that the remaining pieces enclose is a shape. In SVG, a straight edge closes an open path
// that meets no other piece. An unfilled outline that is directly inside a shape is a hole of that
// shape, and a note gives the number of such holes. Filled outlines are shapes, and so are outlines
// in a hole. Outlines that touch or cross are separate shapes.
//
// A rectangle that encloses all else in a drawing is its sheet, not a part, if it is painted white
// without a stroke; if its layer, block or name is one such as frame, border, title block or Rahmen, and
// other outlines have another; if it is as large as the SVG's view box, with more than holes in it; or if several outlines lie in it, one of
// them with a hole of its own. What lies on the sheet is then read as if the sheet were not there, and
// the sheet comes last. Lines that lie directly on it are also its holes, unless it is filled and told by its paint or name.
// Several sheets may lie in each other.
//
// A vertex that equals the preceding one is dropped, with a note unless the text is a drawing. The
// last vertex of a ring is dropped if it equals the first or, in a drawing, if their distance is at
// most 1/100000 of the shape's larger side. In the thesis's format and in links, no vertex is
// dropped; in results, only a last vertex that equals the first is.
//
// If the text says that its coordinates are degrees (GeoJSON without another reference system,
// columns of longitude and latitude, reference systems of EWKT and Esri JSON), they stay as they
// are, with a note. With `project`, a note gives the origin, with at most four decimals, and the
// greatest relative error of a width, if that is at least 0.1 %. It is an error to convert the
// coordinates of a result or a link, or coordinates that cannot be degrees, that reach beyond
// latitude 85 or that span the 180th meridian.
//
// Meshes, STEP, IGES, G-code and other known kinds of files are refused; the error names the kind.
// The geometry is not checked here, but by object_of() (polygon_with_holes.h). On every platform,
// the result depends only on the text and the options. The limits are max_text_bytes, max_vertices
// for all shapes together, max_shapes (in a drawing, holes count as shapes) and, outside drawings,
// max_holes for each shape. O(bytes + points), plus O(n log n) to join the n ends of a drawing's
// pieces, and O(k^2) for its k outlines.
Result<Import> read_shapes(std::string_view text, const ImportOptions& options = {});

// Returns the index of the shape with this number, from 1, or name; without one, the index of the only
// part. An error says why a choice is needed, or why it is none: its code is bad_setting if several
// shapes have the name, otherwise unsupported. O(shapes).
Result<std::size_t> choose_shape(const Import& import, const std::optional<std::string>& wanted);

// The number of shapes that are not sheets, which come last. O(shapes).
std::size_t count_parts(const Import& import);

// Robots that already stand. `capacities` has one entry for each place if any robot has a capacity;
// otherwise it is empty.
struct SupportFile {
  Points places;
  // Where the robots touch the boundary, if the text has any contacts: one for each place, the place
  // itself where the text gives none.
  Points contacts;
  std::vector<std::string> names;  // of each robot, "" for none; or empty
  std::vector<std::size_t> lines;  // where each robot stands in the text, counted from 1
  std::vector<std::string> notes;  // which columns of a table were left out, in sentences
  std::vector<std::optional<double>> capacities;
  std::vector<double> readings;  // of each robot, if a table has a column of them (weighing.h)
  std::optional<InputError> wrong_reading;  // why a cell of that column is none
  // The kilograms in the unit of the capacities and of the readings, if their headings state one.
  std::optional<double> capacity_unit, reading_unit;
  LengthUnit unit = LengthUnit::none;  // as a table or JSON states it; metres for YAML (ROS 2)
  bool is_own = false;                 // evenlift wrote it, so that y points up
};

// Reads the places of robots. The text is a table whose first line names the columns of x and y, and
// perhaps those of a name ("jack"), a capacity ("SWL", "Tragkraft", "max load") and a reading ("load",
// "kg"), each perhaps with its unit as in "capacity (lb)" or "x (ft)"; the JSON of a result
// (robots[].at) or of robot poses, an array [[x, y], ...], or robot poses as YAML. The limits are
// max_text_bytes and most_supports. O(bytes).
Result<SupportFile> read_support_file(std::string_view text);

// Removes the holes and returns the note about them, or an empty text if there are none.
// O(vertices).
std::string leave_out_holes(std::vector<ImportedShape>& shapes);

// Describes a shape, for example `"base plate", rectangle, 4 vertices, 2 holes, 120 x 80`. O(n).
std::string describe(const ImportedShape& shape);

}  // namespace evenlift
