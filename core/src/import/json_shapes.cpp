// GeoJSON of any kind (RFC 7946), Esri's JSON, arrays of points, and evenlift's own results.
#include <cmath>
#include <vector>

#include "document/setting_values.h"
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
      : text_(text), tree_(tree), gathering_(options) {}

  Result<Import> read();

 private:
  InputError error(Index at, ErrorCode code, std::string message) const {
    return text_error(code, std::move(message), text_, tree_.offset(at));
  }
  bool is(std::optional<Index> at, Kind kind) const { return at && tree_.kind(*at) == kind; }

  Result<Import> result_of_evenlift();
  std::optional<InputError> take_setting(Setting setting, Index at, std::string_view value,
                                         Document& document) const;
  std::string value_text(const SettingRow& row, Index at) const;
  std::optional<InputError> take_row(const SettingRow& row, Document& document) const;
  std::optional<InputError> take_teams(Document& document) const;
  std::optional<InputError> take_stands(Document& document) const;
  std::optional<InputError> take_moved(Document& document) const;
  std::optional<InputError> take_supports(Document& document);
  std::optional<InputError> take_uncertainty(Document& document) const;
  std::optional<InputError> take_settings(Document& document);
  std::optional<InputError> take_centre_of_mass(Document& document);
  std::optional<InputError> take_hole(Index ring, Document& document);
  std::optional<InputError> take_holes(Document& document);
  Result<Cargo> cargo_item(Index item);
  std::optional<InputError> take_cargo(Document& document);
  std::optional<InputError> take_overlays(Index overlays, Overlays& shown) const;

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

  void geojson(Index object, std::string_view name, const Document& of);
  void feature(Index object);
  void geometry(Index object, std::string_view name, const Document& of);
  void polygon(Index rings, std::string_view name, const Document& of);
  std::optional<std::string> name_in(Index object, std::string_view member) const;
  std::string name_of(Index feature, std::string_view table) const;
  bool is_geojson_in_degrees() const;
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
  bool of_evenlift_ = false;  // a feature has "centre_of_mass", which only evenlift writes
};

// --- evenlift's own results

// Returns the integer's own digits, since a seed may have more than a double holds. For another
// notation, such as 1e3, returns the text of `value`.
std::string whole_text(std::string_view text, std::size_t last, double value) {
  std::size_t first = last + 1;
  while (first > 0 && text[first - 1] >= '0' && text[first - 1] <= '9') --first;
  const std::string digits(text.substr(first, last + 1 - first));
  const std::optional<double> read = read_number(digits);
  return read && *read == value ? digits : shortest(value);
}

// Whether the boolean that ends here is true.
bool is_true(std::string_view text, std::size_t last) {
  return last >= 3 && text.substr(last - 3, 4) == "true";
}

std::optional<InputError> JsonShapes::take_overlays(Index overlays, Overlays& shown) const {
  for (const NamedOverlay& overlay : all_overlays()) {
    const auto at = tree_.member(overlays, overlay.name);
    if (!at) continue;
    if (!is(at, Kind::boolean)) return error(*at, ErrorCode::bad_setting, "expected true or false");
    shown.*(overlay.shown) = is_true(text_, tree_.offset(*at));
  }
  return std::nullopt;
}

std::optional<InputError> JsonShapes::take_setting(Setting setting, Index at,
                                                   std::string_view value,
                                                   Document& document) const {
  std::optional<InputError> wrong = read_setting(setting, value, document);
  if (wrong) wrong = error(at, wrong->code, wrong->message);
  return wrong;
}

std::string JsonShapes::value_text(const SettingRow& row, Index at) const {
  if (tree_.kind(at) == Kind::string) return std::string(tree_.text(at));
  if (tree_.kind(at) != Kind::number) return {};
  return row.setting == Setting::seed || row.setting == Setting::step
             ? whole_text(text_, tree_.offset(at), tree_.number(at))
             : shortest(tree_.number(at));
}

// Null means unset. Objects and arrays with a setting's name are results.
std::optional<InputError> JsonShapes::take_row(const SettingRow& row, Document& document) const {
  const auto at = tree_.member(0, row.json.empty() ? row.name : row.json);
  if (!at || is(at, Kind::null) || is(at, Kind::object) || is(at, Kind::array)) return std::nullopt;
  return take_setting(row.setting, *at, value_text(row, *at), document);
}

// In a result, `teams` is a list. `requested_teams` is a number even for `max`, and 1 for balanced
// robots and supports; then `teams_asked` holds the setting.
std::optional<InputError> JsonShapes::take_teams(Document& document) const {
  const bool one_team = is_one_team(document.settings.method);
  for (const std::string_view name : {"teams", "requested_teams", "teams_asked"})
    if (const auto at = tree_.member(0, name);
        at && !is(at, Kind::array) && !(one_team && name == "requested_teams"))
      if (auto wrong =
              take_setting(Setting::teams, *at, value_text(row_of(Setting::teams), *at), document))
        return wrong;
  return std::nullopt;
}

// A result always names its goal. The default counts as unset, so that it does not persist when the
// method changes.
void forget_usual_goal(Settings& settings) {
  Settings usual = settings;
  usual.goal.reset();
  if (settings.goal == goal_of(usual)) settings.goal.reset();
}

std::optional<InputError> JsonShapes::take_settings(Document& document) {
  for (const SettingRow& row : all_settings()) {
    if (row.changes == Changes::view || row.setting == Setting::teams) continue;
    if (row.setting == Setting::com) continue;
    if (auto wrong = take_row(row, document)) return wrong;
  }
  if (auto wrong = take_teams(document)) return wrong;
  forget_usual_goal(document.settings);
  if (const auto at = tree_.member(0, "overlays"); is(at, Kind::object))
    if (auto wrong = take_overlays(*at, document.shown.overlays)) return wrong;
  if (auto wrong = take_stands(document)) return wrong;
  if (auto wrong = take_moved(document)) return wrong;
  if (auto wrong = take_supports(document)) return wrong;
  return take_uncertainty(document);
}

// Comes after the other settings, since they put moved robots back.
std::optional<InputError> JsonShapes::take_moved(Document& document) const {
  const auto at = tree_.member(0, "moved");
  if (!is(at, Kind::string)) return std::nullopt;
  auto moved = read_moved(tree_.text(*at));
  if (!moved)
    return error(*at, ErrorCode::bad_setting,
                 "robots moved by hand must be written like 3:0.25,5:0.5,9:1 or 2@3:0.25/9");
  document.moved = *std::move(moved);
  return std::nullopt;
}

// Results contain supports and capacities if the method is `given`.
std::optional<InputError> JsonShapes::take_supports(Document& document) {
  const auto supports = tree_.member(0, "supports"),
             capacities = tree_.member(0, "support_capacities");
  if (!is(supports, Kind::array) || document.settings.method != Method::given) return std::nullopt;
  Result<Points> read = points(*supports);
  if (!read) return read.error();
  if (read->size() > most_supports)
    return error(*supports, ErrorCode::bad_setting, requirement(Setting::supports));
  document.settings.supports = std::move(read).value();
  if (!is(capacities, Kind::array)) return std::nullopt;
  std::string text;
  for (Index i = tree_.first(*capacities); i != tree_.end(*capacities); i = tree_.next(i))
    text += (text.empty() ? "" : ",") +
            (tree_.kind(i) == Kind::number ? shortest(tree_.number(i)) : std::string("none"));
  return take_setting(Setting::support_capacities, *capacities, text, document);
}

// The members are named like the settings of the robots' size, without the prefix.
std::optional<InputError> JsonShapes::take_stands(Document& document) const {
  const auto robot = tree_.member(0, "robot");
  if (!is(robot, Kind::object)) return std::nullopt;
  constexpr std::string_view beginning = "robot_";
  for (const SettingRow& row : all_settings()) {
    if (!row.name.starts_with(beginning)) continue;
    const auto at = tree_.member(*robot, row.name.substr(beginning.size()));
    if (!is(at, Kind::number)) continue;
    if (auto wrong = take_setting(row.setting, *at, shortest(tree_.number(*at)), document))
      return wrong;
  }
  return std::nullopt;
}

// A result contains these next to values computed with them.
std::optional<InputError> JsonShapes::take_uncertainty(Document& document) const {
  const auto within = [&](const char* object, const char* member) {
    const auto at = tree_.member(0, object);
    return is(at, Kind::object) ? tree_.member(*at, member) : at;
  };
  for (const auto& [setting, at] : {std::pair(Setting::capacity, within("capacity", "limit")),
                                    {Setting::com_radius, within("robustness", "com_radius")},
                                    {Setting::accuracy, within("accuracy", "asked")},
                                    {Setting::extra, within("extra", "weight")},
                                    {Setting::accuracy, within("accuracy", "asked")}})
    // A result always has an accuracy, 0 if none was asked for.
    if (is(at, Kind::number) && (setting != Setting::accuracy || tree_.number(*at) != 0))
      if (auto wrong = take_setting(setting, *at, shortest(tree_.number(*at)), document))
        return wrong;
  return std::nullopt;
}

// A result always names its centre of mass. One that equals the centroid bit for bit counts as
// unset.
void forget_centroid(Document& document) {
  const Result<PolygonWithHoles> object = object_of(document);
  if (object && document.centre_of_mass && object->centroid() == *document.centre_of_mass)
    document.centre_of_mass.reset();
}

// With cargo, `centre_of_mass` is that of object and cargo together.
std::optional<InputError> JsonShapes::take_centre_of_mass(Document& document) {
  auto centre = tree_.member(0, "own_centre_of_mass");
  if (!centre) centre = tree_.member(0, "centre_of_mass");
  if (!centre || is(centre, Kind::null)) return std::nullopt;
  const Result<Vec2> at = point(*centre);
  if (!at) return at.error();
  document.centre_of_mass = *at;
  forget_centroid(document);
  return std::nullopt;
}

std::optional<InputError> JsonShapes::take_hole(Index ring, Document& document) {
  if (document.holes.size() == gathering_.most_holes())
    return error(ring, ErrorCode::too_many_vertices, no_more_holes);
  Result<Points> hole = points(ring);
  if (!hole) return hole.error();
  if (hole->empty()) return error(ring, ErrorCode::too_few_vertices, no_vertices_of_hole);
  document.holes.push_back(std::move(hole).value());
  return std::nullopt;
}

std::optional<InputError> JsonShapes::take_holes(Document& document) {
  const auto holes = tree_.member(0, "holes");
  if (!holes || is(holes, Kind::null)) return std::nullopt;
  if (!is(holes, Kind::array))
    return error(*holes, ErrorCode::bad_syntax,
                 "expected an array of holes, each an array of points [x, y]");
  for (Index i = tree_.first(*holes); i != tree_.end(*holes); i = tree_.next(i))
    if (auto wrong = take_hole(i, document)) return wrong;
  return std::nullopt;
}

// The name may be missing.
Result<Cargo> JsonShapes::cargo_item(Index item) {
  const bool is_object = tree_.kind(item) == Kind::object;
  const auto at = is_object ? tree_.member(item, "at") : std::nullopt;
  const auto weight = is_object ? tree_.member(item, "weight") : std::nullopt;
  const auto name = is_object ? tree_.member(item, "name") : std::nullopt;
  if (!at || !is(weight, Kind::number) || (name && !is(name, Kind::string)))
    return error(item, ErrorCode::bad_syntax,
                 R"(expected cargo like {"at": [x, y], "weight": w, "name": "..."})");
  const Result<Vec2> place = point(*at);
  if (!place) return place.error();
  Cargo cargo{*place, tree_.number(*weight), name ? std::string(tree_.text(*name)) : ""};
  if (const char* fault = fault_of_cargo_weight(cargo.weight))
    return error(*weight, ErrorCode::bad_setting, fault);
  if (const char* fault = fault_of_cargo_name(cargo.name))
    return error(*name, ErrorCode::bad_setting, fault);
  return cargo;
}

std::optional<InputError> JsonShapes::take_cargo(Document& document) {
  const auto items = tree_.member(0, "cargo");
  if (!items || is(items, Kind::null)) return std::nullopt;
  if (!is(items, Kind::array))
    return error(*items, ErrorCode::bad_syntax, "expected an array of cargo");
  for (Index i = tree_.first(*items); i != tree_.end(*items); i = tree_.next(i)) {
    if (document.settings.cargo.size() == max_cargo)
      return error(i, ErrorCode::bad_setting, no_more_cargo);
    Result<Cargo> item = cargo_item(i);
    if (!item) return item.error();
    document.settings.cargo.push_back(std::move(item).value());
  }
  return std::nullopt;
}

Result<Import> JsonShapes::result_of_evenlift() {
  gathering_.import.format = "result of evenlift";
  gathering_.import.has_settings = true;
  Result<Points> vertices = points(*tree_.member(0, "polygon"));
  if (!vertices) return vertices.error();
  Document document;
  document.vertices = std::move(vertices).value();
  if (auto wrong = take_holes(document)) return *std::move(wrong);
  if (auto wrong = take_centre_of_mass(document)) return *std::move(wrong);
  if (auto wrong = take_cargo(document)) return *std::move(wrong);
  if (auto wrong = take_settings(document)) return *std::move(wrong);
  gathering_.add(std::move(document), "", "polygon");
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
  if (tree_.kind(at) != Kind::array) return refused();
  double values[2] = {0, 0};
  std::size_t count = 0;
  for (Index i = tree_.first(at); i != tree_.end(at); i = tree_.next(i)) {
    if (tree_.kind(i) != Kind::number) return refused();
    if (count < 2) values[count] = tree_.number(i);
    ++count;
  }
  if (count < 2) return refused();
  if (count > 2) ++notes_.heights;
  return Vec2(values[0], values[1]);
}

Result<Points> JsonShapes::points(Index array) {
  if (tree_.kind(array) != Kind::array)
    return error(array, ErrorCode::bad_syntax, "expected an array of points [x, y]");
  Points ring;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (ring.size() > max_vertices)  // one more may close the ring
      return error(i, ErrorCode::too_many_vertices, "the polygon has more than 1048576 vertices");
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
      geojson(i, name, {});
    else if (tree_.kind(i) == Kind::object && is_esri(i))
      esri(i);
    else
      gathering_.left_out.add("other value", "other values");
  }
}

// --- GeoJSON

// Capitals do not matter in names.
std::optional<std::string> JsonShapes::name_in(Index object, std::string_view member) const {
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    if (!same_word(tree_.name(i), member)) continue;
    if (tree_.kind(i) == Kind::string) return std::string(tree_.text(i));
    if (tree_.kind(i) == Kind::number) return shortest(tree_.number(i));
  }
  return std::nullopt;
}

std::string JsonShapes::name_of(Index feature, std::string_view table) const {
  const auto properties = tree_.member(feature, table);
  for (const char* name : {"name", "title", "id", "objectid", "fid"}) {
    std::optional<std::string> found;
    if (is(properties, Kind::object)) found = name_in(*properties, name);
    if (!found && std::string_view(name) == "id") found = name_in(feature, name);
    if (found) return *std::move(found);
  }
  return "";
}

void JsonShapes::polygon(Index rings, std::string_view name, const Document& of) {
  if (tree_.kind(rings) != Kind::array)
    return gathering_.add_problem(
        error(rings, ErrorCode::bad_syntax, "expected an array of rings of positions [x, y]"));
  const Index first = tree_.first(rings);
  if (first == tree_.end(rings))
    return gathering_.add_problem(error(rings, ErrorCode::too_few_vertices, no_vertices));
  Result<Points> ring = points(first);
  if (!ring) return gathering_.add_problem(ring.error());
  Document document = of;
  document.vertices = std::move(ring).value();
  for (Index i = tree_.next(first); i != tree_.end(rings); i = tree_.next(i))
    if (auto wrong = take_hole(i, document)) return gathering_.add_problem(*std::move(wrong));
  notes_.drop_repeated(document.vertices);
  for (Points& hole : document.holes) notes_.drop_repeated(hole);
  gathering_.add(std::move(document), name, "polygon");
}

void JsonShapes::geometry(Index object, std::string_view name, const Document& of) {
  const auto type = tree_.member(object, "type");
  const auto coordinates = tree_.member(object, "coordinates");
  if (!is(type, Kind::string))
    return gathering_.add_problem(
        error(object, ErrorCode::bad_syntax, "the geometry has no \"type\""));
  const std::string_view kind = tree_.text(*type);
  if (kind == "Polygon" || kind == "MultiPolygon") {
    if (!coordinates)
      return gathering_.add_problem(
          error(*type, ErrorCode::bad_syntax, say("the {kind} has no \"coordinates\"", {kind})));
    if (kind == "Polygon" || !is(coordinates, Kind::array)) return polygon(*coordinates, name, of);
    for (Index i = tree_.first(*coordinates); i != tree_.end(*coordinates); i = tree_.next(i))
      polygon(i, name, of);
  } else if (kind == "GeometryCollection") {
    const auto all = tree_.member(object, "geometries");
    if (!is(all, Kind::array))
      return gathering_.add_problem(
          error(*type, ErrorCode::bad_syntax, "the GeometryCollection has no \"geometries\""));
    for (Index i = tree_.first(*all); i != tree_.end(*all); i = tree_.next(i))
      geometry(i, name, of);
  } else {
    const std::string clean = clean_name(kind);
    gathering_.left_out.add(clean, clean + "s");
  }
}

void JsonShapes::feature(Index object) {
  Document with_centre;
  const auto properties = tree_.member(object, "properties");
  const auto centre =
      is(properties, Kind::object) ? tree_.member(*properties, "centre_of_mass") : std::nullopt;
  if (centre && !is(centre, Kind::null)) {
    const Result<Vec2> at = point(*centre);
    if (!at)
      return gathering_.add_problem(
          error(*centre, ErrorCode::bad_syntax, "\"centre_of_mass\" is not [x, y]"));
    with_centre.centre_of_mass = *at;
  }
  if (centre) of_evenlift_ = true;
  const auto shape = tree_.member(object, "geometry");
  if (!is(shape, Kind::object))
    return gathering_.left_out.add("feature without a geometry", "features without a geometry");
  geometry(*shape, name_of(object, "properties"), with_centre);
}

void JsonShapes::geojson(Index object, std::string_view name, const Document& of) {
  if (gathering_.full()) return;
  const auto type = tree_.member(object, "type");
  if (tree_.is_string(type, "FeatureCollection")) {
    const auto features = tree_.member(object, "features");
    if (!is(features, Kind::array))
      return gathering_.add_problem(
          error(*type, ErrorCode::bad_syntax, "the FeatureCollection has no \"features\""));
    for (Index i = tree_.first(*features); i != tree_.end(*features); i = tree_.next(i))
      geojson(i, "", {});
  } else if (tree_.is_string(type, "Feature")) {
    feature(object);
  } else {
    geometry(object, name, of);
  }
}

// By the standard the coordinates are degrees, unless the text names another reference system, as
// older GeoJSON does.
bool JsonShapes::is_geojson_in_degrees() const {
  const auto system = tree_.member(0, "crs");
  if (of_evenlift_) return false;
  if (!is(system, Kind::object)) return true;
  const auto properties = tree_.member(*system, "properties");
  const auto name = is(properties, Kind::object) ? tree_.member(*properties, "name") : std::nullopt;
  if (!is(name, Kind::string)) return false;
  const std::string_view text = tree_.text(*name);
  const std::size_t colon = text.rfind(':');
  const std::string_view code = colon == std::string_view::npos ? text : text.substr(colon + 1);
  return code == "CRS84" || is_in_degrees(read_number(code).value_or(0));
}

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
  for (const OutlineWithHoles& shape : filled_shapes(each, Fill::nonzero)) {
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
    return esri_rings(*rings, name_of(object, "attributes"));
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
  notes_.add_to(gathering_);
  const std::string found = gathering_.left_out.list();
  return gathering_.finish(
      {ErrorCode::unsupported,
       found.empty() ? say("this {format} has no polygon", {format})
                     : say("this {format} has no polygon, only {things}", {format, found}),
       {}});
}

Result<Import> JsonShapes::read_array() {
  if (lists_robots(tree_.root()))
    return InputError{ErrorCode::unsupported, robots_are_no_polygon, {}};
  gathering_.import.format = "points in JSON";
  arrays(tree_.root(), "");
  notes_.add_to(gathering_);
  return gathering_.finish({ErrorCode::bad_syntax, "this JSON has no list of points [x, y]", {}});
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
    return InputError{ErrorCode::unsupported, robots_are_no_polygon, {}};
  if (tree_.is_string(tree_.member(0, "type"), "Topology"))
    return InputError{ErrorCode::unsupported,
                      "this is TopoJSON, which evenlift does not read: convert it to GeoJSON",
                      {}};
  if (!tree_.member(0, "type")) {
    if (read_esri()) return finish("Esri JSON");
    read_members();
    notes_.add_to(gathering_);
    return gathering_.finish(
        {ErrorCode::bad_syntax,
         "this JSON is neither GeoJSON (it has no \"type\") nor a result that evenlift "
         "saved (it has no \"polygon\")",
         {}});
  }
  gathering_.import.format = "GeoJSON";
  geojson(0, "", {});
  if (is_geojson_in_degrees()) {
    notes_.are_degrees = true;
    notes_.in_degrees =
        "by the standard of GeoJSON its coordinates are degrees of longitude and latitude, not "
        "lengths";
  }
  return finish("GeoJSON");
}

}  // namespace

Result<Import> read_json_shapes(std::string_view text, const ImportOptions& options) {
  const Result<JsonTree> tree = JsonTree::read(text);
  if (!tree) return tree.error();
  return JsonShapes(text, *tree, options).read();
}

}  // namespace evenlift
