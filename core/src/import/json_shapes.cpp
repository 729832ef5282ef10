// Shapes in JSON: GeoJSON of any kind (RFC 7946), arrays of points, and evenlift's own results.
#include <cmath>

#include "evenlift/formats.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon.h"
#include "evenlift/settings.h"
#include "formats/readers.h"
#include "import/gathering.h"
#include "import/readers.h"
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
  std::optional<InputError> take_overlays(Index overlays, Overlays& shown) const;

  void arrays(Index array);
  bool is_point(Index at) const;
  Result<Points> points(Index array);
  Result<Vec2> point(Index at);

  void geojson(Index object, std::string_view name, const Document& of);
  void feature(Index object);
  void geometry(Index object, std::string_view name, const Document& of);
  void polygon(Index rings, std::string_view name, const Document& of);
  std::string name_of(Index feature) const;
  const char* what_is_left() const;
  bool lists_robots(Index array) const;

  std::string_view text_;
  const JsonTree& tree_;
  Gathering gathering_;
  std::size_t heights_ = 0, holes_ = 0;
  bool centre_of_holed_is_open_ = false;  // a polygon with holes comes without a centre of mass
};

// --- evenlift's own results

// All digits of the integer that ends at the offset: a seed may have more digits than a double
// holds. For another notation, such as 1e3, its value.
std::string whole_text(std::string_view text, std::size_t last, double value) {
  std::size_t first = last + 1;
  while (first > 0 && text[first - 1] >= '0' && text[first - 1] <= '9') --first;
  const std::string digits(text.substr(first, last + 1 - first));
  const std::optional<double> read = read_number(digits);
  return read && *read == value ? digits : shortest(value);
}

// Whether true, not false, ends at the offset.
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

// An integer keeps all its digits: a seed may have more than a double holds.
std::string JsonShapes::value_text(const SettingRow& row, Index at) const {
  if (tree_.kind(at) == Kind::string) return std::string(tree_.text(at));
  if (tree_.kind(at) != Kind::number) return {};
  return row.setting == Setting::seed || row.setting == Setting::step
             ? whole_text(text_, tree_.offset(at), tree_.number(at))
             : shortest(tree_.number(at));
}

// Reads a setting that is a member by itself, a number or a word. Null means that it is not set.
// Objects and arrays are results of the same name.
std::optional<InputError> JsonShapes::take_row(const SettingRow& row, Document& document) const {
  const auto at = tree_.member(0, row.json.empty() ? row.name : row.json);
  if (!at || is(at, Kind::null) || is(at, Kind::object) || is(at, Kind::array)) return std::nullopt;
  return take_setting(row.setting, *at, value_text(row, *at), document);
}

// A result lists its teams and gives the requested number. For `max` that is a plain number, and
// for balanced robots and supports it is 1: then `teams_asked` holds the setting.
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

// A result always names its goal. The default goal counts as unset, so it does not persist when the
// method changes.
void forget_usual_goal(Settings& settings) {
  Settings usual = settings;
  usual.goal.reset();
  if (settings.goal == goal_of(usual)) settings.goal.reset();
}

// Reads the settings from the members of the object: a result, or the output of `link decode`.
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

// Reads the robots that were moved by hand. This comes after the settings, which put robots back.
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

// Reads the supports and their capacities. A result contains them if its method is `given`.
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

// Reads the robots' size, an object whose members have the names of the settings without the
// prefix.
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

// Reads the capacity and the C uncertainty. A result contains them among the values computed with
// them.
std::optional<InputError> JsonShapes::take_uncertainty(Document& document) const {
  const auto within = [&](const char* object, const char* member) {
    const auto at = tree_.member(0, object);
    return is(at, Kind::object) ? tree_.member(*at, member) : at;
  };
  for (const auto& [setting, at] : {std::pair(Setting::capacity, within("capacity", "limit")),
                                    {Setting::com_radius, within("robustness", "com_radius")}})
    if (is(at, Kind::number))
      if (auto wrong = take_setting(setting, *at, shortest(tree_.number(*at)), document))
        return wrong;
  return std::nullopt;
}

// A result always names its centre of mass. If it equals the centroid bit for bit, it is the
// centroid.
void forget_centroid(Document& document) {
  const Result<Polygon> polygon = Polygon::create(document.vertices);
  if (polygon && document.centre_of_mass && polygon->centroid() == *document.centre_of_mass)
    document.centre_of_mass.reset();
}

Result<Import> JsonShapes::result_of_evenlift() {
  gathering_.import.format = "result of evenlift";
  gathering_.import.has_settings = true;
  Result<Points> vertices = points(*tree_.member(0, "polygon"));
  if (!vertices) return vertices.error();
  Document document;
  document.vertices = std::move(vertices).value();
  const auto centre = tree_.member(0, "centre_of_mass");
  if (centre && !is(centre, Kind::null)) {
    const Result<Vec2> at = point(*centre);
    if (!at) return at.error();
    document.centre_of_mass = *at;
    forget_centroid(document);
  }
  if (auto wrong = take_settings(document)) return *std::move(wrong);
  gathering_.add(std::move(document), "", "polygon");
  return gathering_.finish(error(0, ErrorCode::too_few_vertices, no_vertices));
}

// --- Points

bool JsonShapes::is_point(Index at) const {
  if (tree_.kind(at) == Kind::object) return tree_.member(at, "x") && tree_.member(at, "y");
  return tree_.kind(at) == Kind::array && tree_.first(at) != tree_.end(at) &&
         tree_.kind(tree_.first(at)) == Kind::number;
}

Result<Vec2> JsonShapes::point(Index at) {
  const auto refused = [&] {
    return error(at, ErrorCode::bad_syntax, "expected a point [x, y] of two numbers");
  };
  if (tree_.kind(at) == Kind::object) {
    const auto x = tree_.member(at, "x"), y = tree_.member(at, "y");
    if (!is(x, Kind::number) || !is(y, Kind::number)) return refused();
    return Vec2(tree_.number(*x), tree_.number(*y));
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
  if (count > 2) ++heights_;
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

// An array of points is a shape; an array of anything else may contain some.
void JsonShapes::arrays(Index array) {
  if (gathering_.full()) return;
  const Index first = tree_.first(array);
  if (first != tree_.end(array) && is_point(first)) {
    Result<Points> ring = points(array);
    if (!ring) return gathering_.add_problem(ring.error());
    Document document;
    document.vertices = std::move(ring).value();
    return gathering_.add(std::move(document), "", "points");
  }
  for (Index i = first; i != tree_.end(array); i = tree_.next(i)) {
    if (tree_.kind(i) == Kind::array)
      arrays(i);
    else if (tree_.kind(i) == Kind::object && tree_.member(i, "type"))
      geojson(i, "", {});
    else
      gathering_.left_out.add("other value", "other values");
  }
}

// --- GeoJSON

std::string JsonShapes::name_of(Index feature) const {
  const auto properties = tree_.member(feature, "properties");
  for (const char* name : {"name", "title", "id"}) {
    auto at = is(properties, Kind::object) ? tree_.member(*properties, name) : std::nullopt;
    if (!at && std::string_view(name) == "id") at = tree_.member(feature, name);
    if (is(at, Kind::string)) return std::string(tree_.text(*at));
    if (is(at, Kind::number)) return shortest(tree_.number(*at));
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
  for (Index i = tree_.next(first); i != tree_.end(rings); i = tree_.next(i)) ++holes_;
  if (tree_.next(first) != tree_.end(rings) && !of.centre_of_mass) centre_of_holed_is_open_ = true;
  Document document = of;
  document.vertices = std::move(ring).value();
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
      return gathering_.add_problem(error(*type, ErrorCode::bad_syntax,
                                          "the " + std::string(kind) + " has no \"coordinates\""));
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
  const auto shape = tree_.member(object, "geometry");
  if (!is(shape, Kind::object))
    return gathering_.left_out.add("feature without a geometry", "features without a geometry");
  geometry(*shape, name_of(object), with_centre);
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

// Describes a polygon without its holes. An option may still set a centre of mass later.
const char* JsonShapes::what_is_left() const {
  return centre_of_holed_is_open_
             ? "only the outer ring defines the shape and, unless one is given, its centre of mass"
             : "only the outer ring defines the shape; the centre of mass is the given one";
}

// Whether an array lists robots, like a table of robots converted to JSON.
bool JsonShapes::lists_robots(Index array) const {
  const Index first = tree_.first(array);
  return first != tree_.end(array) && tree_.member(first, "robot") && is_point(first);
}

Result<Import> JsonShapes::read() {
  if (is(tree_.root(), Kind::array)) {
    if (lists_robots(tree_.root()))
      return InputError{ErrorCode::unsupported, robots_are_no_polygon, {}};
    gathering_.import.format = "points in JSON";
    arrays(tree_.root());
    return gathering_.finish({ErrorCode::bad_syntax, "this JSON has no list of points [x, y]", {}});
  }
  if (tree_.member(0, "polygon")) return result_of_evenlift();
  if (is(tree_.member(0, "robots"), Kind::array) && tree_.member(0, "frame"))
    return InputError{ErrorCode::unsupported, robots_are_no_polygon, {}};
  if (!tree_.member(0, "type"))
    return InputError{
        ErrorCode::bad_syntax,
        "this JSON is neither GeoJSON (it has no \"type\") nor a result that evenlift "
        "saved (it has no \"polygon\")",
        {}};
  gathering_.import.format = "GeoJSON";
  geojson(0, "", {});
  if (holes_ > 0)
    gathering_.note(counted(holes_, "hole was", "holes were") +
                    " left out, since holes are not supported: " + what_is_left());
  if (heights_ > 0) gathering_.note("coordinates beyond x and y were left out");
  const std::string found = gathering_.left_out.list();
  return gathering_.finish(
      {ErrorCode::unsupported,
       joined({"this GeoJSON has no polygon", found.empty() ? "" : ", only ", found}),
       {}});
}

}  // namespace

Result<Import> read_json_shapes(std::string_view text, const ImportOptions& options) {
  const Result<JsonTree> tree = JsonTree::read(text);
  if (!tree) return tree.error();
  return JsonShapes(text, *tree, options).read();
}

}  // namespace evenlift
