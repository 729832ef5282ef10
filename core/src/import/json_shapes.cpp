// JSON: GeoJSON, Esri's, arrays of points, and evenlift's own results.
#include <cmath>
#include <vector>

#include "document/document_json.h"
#include "evenlift/formats.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "formats/readers.h"
#include "import/gathering.h"
#include "import/joining/joining.h"
#include "import/readers.h"
#include "import/tables/table_headings.h"
#include "numbers/json_tree.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

using Kind = JsonTree::Kind;
using Index = JsonTree::Index;

class JsonShapes {
 public:
  JsonShapes(std::string_view text, const JsonTree& tree, const ImportOptions& options)
      : text_(text), tree_(tree), gathering_(options), geojson_(text, tree, gathering_, notes_) {}

  Result<Import> read();

 private:
  InputError error(Index at, ErrorCode code, std::string message) const {
    return text_error(code, std::move(message), text_, tree_.offset(at));
  }
  bool is(std::optional<Index> at, Kind kind) const { return at && tree_.kind(*at) == kind; }

  Result<Import> result_of_evenlift();

  void arrays(Index array, std::string_view name);
  // Such as {"x": 1, "y": 2} or {"lon": 1, "lat": 2}.
  struct Members {
    Index x, y;
    bool are_degrees;
  };
  std::optional<Members> members_of_point(Index object) const;
  bool is_point(Index at) const;
  Result<Points> points(Index array);
  Result<Vec2> point(Index at);

  bool is_esri(Index object) const;
  bool is_esri_geometry(Index object) const;
  void esri_rings(Index rings, std::string_view name);
  void take_esri_system(Index object);
  void esri(Index object);
  bool read_esri();
  bool lists_robots(Index array) const;
  Result<Import> read_array();
  void read_members();
  Result<Import> finish(const char* format);

  std::string_view text_;
  const JsonTree& tree_;
  Gathering gathering_;
  RingNotes notes_;
  GeojsonReader geojson_;
};

// --- evenlift's own results

Result<Import> JsonShapes::result_of_evenlift() {
  gathering_.import.format = "result of evenlift";
  gathering_.import.has_settings = true;
  DocumentReader reader(text_, tree_, DocumentReader::From::file);
  Result<Document> document = read_written(reader, 0);
  if (!document) return document.error();
  gathering_.add(*std::move(document), "", "polygon");
  for (const std::string& notice : reader.notices()) gathering_.import.notes.push_back(notice);
  return gathering_.finish(error(0, ErrorCode::too_few_vertices, no_vertices));
}

// --- Points

// Capitals do not matter in names.
std::optional<JsonShapes::Members> JsonShapes::members_of_point(Index object) const {
  std::optional<Index> x, y, longitude, latitude;
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const Column column = column_of(tree_.name(i));
    if (column == Column::x || column == Column::easting) x = i;
    if (column == Column::y || column == Column::northing) y = i;
    if (column == Column::longitude) longitude = i;
    if (column == Column::latitude) latitude = i;
  }
  if (x && y) return Members{*x, *y, false};
  if (longitude && latitude) return Members{*longitude, *latitude, true};
  return std::nullopt;
}

bool JsonShapes::is_point(Index at) const {
  if (tree_.kind(at) == Kind::object) return members_of_point(at).has_value();
  return tree_.kind(at) == Kind::array && tree_.first(at) != tree_.end(at) &&
         tree_.kind(tree_.first(at)) == Kind::number;
}

Result<Vec2> JsonShapes::point(Index at) {
  const auto refused = [&] {
    return error(at, ErrorCode::bad_syntax, "expected a point [x, y] of two numbers");
  };
  if (tree_.kind(at) == Kind::object) {
    const auto members = members_of_point(at);
    if (!members || !is(members->x, Kind::number) || !is(members->y, Kind::number))
      return refused();
    if (members->are_degrees) notes_.are_degrees = true;
    return Vec2(tree_.number(members->x), tree_.number(members->y));
  }
  return geojson_.position(at);
}

Result<Points> JsonShapes::points(Index array) {
  if (tree_.kind(array) != Kind::array)
    return error(array, ErrorCode::bad_syntax, "expected an array of points [x, y]");
  Points ring;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (ring.size() > max_vertices)  // one more may close the ring
      return error(i, ErrorCode::too_many_vertices, no_more_vertices);
    const Result<Vec2> at = point(i);
    if (!at) return at.error();
    ring.push_back(*at);
  }
  return ring;
}

// An array of points is a shape. Other arrays may contain shapes.
void JsonShapes::arrays(Index array, std::string_view name) {
  if (gathering_.full()) return;
  const Index first = tree_.first(array);
  if (first != tree_.end(array) && is_point(first)) {
    Result<Points> ring = points(array);
    if (!ring) return gathering_.add_problem(ring.error());
    Document document;
    document.vertices = std::move(ring).value();
    notes_.drop_repeated(document.vertices);
    return gathering_.add(std::move(document), name, "points");
  }
  for (Index i = first; i != tree_.end(array); i = tree_.next(i)) {
    if (tree_.kind(i) == Kind::array)
      arrays(i, name);
    else if (tree_.kind(i) == Kind::object && tree_.member(i, "type"))
      geojson_.take(i, name);
    else if (tree_.kind(i) == Kind::object && is_esri(i))
      esri(i);
    else
      gathering_.left_out.add("other value", "other values");
  }
}

// --- GeoJSON

// --- Esri's JSON

bool JsonShapes::is_esri(Index object) const {
  const auto shape = tree_.member(object, "geometry");
  if (is(shape, Kind::object)) return is_esri_geometry(*shape);
  return is_esri_geometry(object);
}

bool JsonShapes::is_esri_geometry(Index object) const {
  return tree_.member(object, "rings") || tree_.member(object, "curveRings") ||
         tree_.member(object, "paths");
}

// Esri's holes run in the opposite direction to their outline, islands in holes in the same one.
void JsonShapes::esri_rings(Index rings, std::string_view name) {
  if (tree_.kind(rings) != Kind::array)
    return gathering_.add_problem(
        error(rings, ErrorCode::bad_syntax, "expected an array of rings of positions [x, y]"));
  std::vector<Points> all;
  for (Index i = tree_.first(rings); i != tree_.end(rings); i = tree_.next(i)) {
    Result<Points> ring = points(i);
    if (!ring) return gathering_.add_problem(ring.error());
    if (ring->empty()) continue;
    if (all.size() == max_shapes)
      return gathering_.add_problem(
          error(i, ErrorCode::unsupported, "the polygon has more than 10000 rings"));
    notes_.drop_repeated(*ring);
    all.push_back(std::move(ring).value());
  }
  static_assert(max_shapes == 10000, "the message names the number");
  std::vector<const Points*> each;
  for (const Points& ring : all) each.push_back(&ring);
  for (const OutlineWithHoles& shape : gathering_.shapes_meant(each, Fill::nonzero)) {
    Document document;
    document.vertices = std::move(all[shape.outline]);
    for (const std::size_t hole : shape.holes) document.holes.push_back(std::move(all[hole]));
    gathering_.add(std::move(document), name, "polygon");
  }
}

void JsonShapes::take_esri_system(Index object) {
  const auto system = tree_.member(object, "spatialReference");
  if (!is(system, Kind::object)) return;
  for (const char* name : {"wkid", "latestWkid"})
    if (const auto code = tree_.member(*system, name);
        is(code, Kind::number) && is_in_degrees(tree_.number(*code)))
      notes_.are_degrees = true;
}

void JsonShapes::esri(Index object) {
  if (gathering_.full()) return;
  take_esri_system(object);
  const auto inner = tree_.member(object, "geometry");
  const Index shape = is(inner, Kind::object) ? *inner : object;
  if (shape != object) take_esri_system(shape);
  if (const auto rings = tree_.member(shape, "rings"))
    return esri_rings(*rings, geojson_.name_of(object, "attributes"));
  if (tree_.member(shape, "curveRings"))
    return gathering_.left_out.add("polygon with curves", "polygons with curves");
  if (tree_.member(shape, "paths")) return gathering_.left_out.add("line", "lines");
  gathering_.left_out.add("feature without a polygon", "features without a polygon");
}

// Returns whether the JSON is Esri's.
bool JsonShapes::read_esri() {
  const auto features = tree_.member(0, "features");
  const bool is_set =
      is(features, Kind::array) &&
      (tree_.member(0, "geometryType") || tree_.member(0, "spatialReference") ||
       (tree_.first(*features) != tree_.end(*features) &&
        tree_.kind(tree_.first(*features)) == Kind::object && is_esri(tree_.first(*features))));
  if (!is_set && !is_esri(0)) return false;
  gathering_.import.format = "Esri JSON";
  if (!is_set) {
    esri(0);
    return true;
  }
  take_esri_system(0);
  for (Index i = tree_.first(*features); i != tree_.end(*features); i = tree_.next(i)) {
    if (tree_.kind(i) == Kind::object)
      esri(i);
    else
      gathering_.left_out.add("other value", "other values");
  }
  return true;
}

// --- The whole

// Whether it is a table of robots converted to JSON.
bool JsonShapes::lists_robots(Index array) const {
  const Index first = tree_.first(array);
  return first != tree_.end(array) && tree_.member(first, "robot") && is_point(first);
}

Result<Import> JsonShapes::finish(const char* format) {
  gathering_.add_notes(notes_);
  const std::string found = gathering_.left_out.list();
  return gathering_.finish(
      {ErrorCode::unsupported,
       found.empty() ? say("this {format} has no polygon", {format})
                     : say("this {format} has no polygon, only {things}", {format, found})});
}

Result<Import> JsonShapes::read_array() {
  if (lists_robots(tree_.root())) return InputError{ErrorCode::unsupported, robots_are_no_polygon};
  gathering_.import.format = "points in JSON";
  arrays(tree_.root(), "");
  gathering_.add_notes(notes_);
  return gathering_.finish({ErrorCode::bad_syntax, "this JSON has no list of points [x, y]"});
}

// Reads members such as {"points": [[0, 0], ...]}, and lists of such lists.
void JsonShapes::read_members() {
  gathering_.import.format = "points in JSON";
  for (Index i = tree_.first(0); i != tree_.end(0); i = tree_.next(i)) {
    if (tree_.kind(i) != Kind::array || tree_.first(i) == tree_.end(i)) continue;
    const Index first = tree_.first(i);
    const bool of_points = is_point(first);
    const bool of_lists = tree_.kind(first) == Kind::array &&
                          tree_.first(first) != tree_.end(first) && is_point(tree_.first(first));
    if (of_points || of_lists) arrays(i, tree_.name(i));
  }
}

Result<Import> JsonShapes::read() {
  if (is(tree_.root(), Kind::array)) return read_array();
  if (tree_.member(0, "polygon")) return result_of_evenlift();
  if (is(tree_.member(0, "robots"), Kind::array) && tree_.member(0, "frame"))
    return InputError{ErrorCode::unsupported, robots_are_no_polygon};
  if (tree_.is_string(tree_.member(0, "type"), "Topology"))
    return InputError{ErrorCode::unsupported,
                      "this is TopoJSON, which evenlift does not read: convert it to GeoJSON"};
  if (!tree_.member(0, "type")) {
    if (read_esri()) return finish("Esri JSON");
    read_members();
    gathering_.add_notes(notes_);
    return gathering_.finish(
        {ErrorCode::bad_syntax,
         "this JSON is neither GeoJSON (it has no \"type\") nor a result that evenlift "
         "saved (it has no \"polygon\")"});
  }
  gathering_.import.format = "GeoJSON";
  geojson_.take_all();
  return finish("GeoJSON");
}

}  // namespace

namespace {

// A result always names its goal. The default counts as unset, so that it does not persist when the
// method changes.
void forget_usual_goal(Settings& settings) {
  Settings usual = settings;
  usual.goal.reset();
  if (settings.goal == goal_of(usual)) settings.goal.reset();
}

// It also always names its centre of mass. One that equals the centroid bit for bit counts as unset.
void forget_centroid(Document& document) {
  const Result<PolygonWithHoles> object = object_of(document);
  if (object && document.centre_of_mass && object->centroid() == *document.centre_of_mass)
    document.centre_of_mass.reset();
}

}  // namespace

Result<Document> read_written(DocumentReader& reader, JsonTree::Index object) {
  Document document;
  if (auto wrong = reader.read(object, document)) return *std::move(wrong);
  forget_usual_goal(document.settings);
  forget_centroid(document);
  return document;
}

Result<Import> read_json_shapes(std::string_view text, const ImportOptions& options) {
  const Result<JsonTree> tree = JsonTree::read(text);
  if (!tree) return tree.error();
  return JsonShapes(text, *tree, options).read();
}

}  // namespace evenlift
