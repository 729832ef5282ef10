// GeoJSON.
#include "evenlift/numbers.h"
#include "evenlift/wording.h"
#include "formats/readers.h"

namespace evenlift {

using Kind = JsonTree::Kind;

InputError GeojsonReader::error(Index at, ErrorCode code, std::string message) const {
  return text_error(code, std::move(message), text_, tree_.offset(at));
}

Result<Vec2> GeojsonReader::position(Index array) {
  const auto refused = [&] {
    return error(array, ErrorCode::bad_syntax, "expected a point [x, y] of two numbers");
  };
  if (tree_.kind(array) != Kind::array) return refused();
  double values[2] = {0, 0};
  std::size_t count = 0;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (tree_.kind(i) != Kind::number) return refused();
    if (count < 2) values[count] = tree_.number(i);
    ++count;
  }
  if (count < 2) return refused();
  if (count > 2) ++notes_.heights;
  return Vec2(values[0], values[1]);
}

Result<Points> GeojsonReader::ring(Index array) {
  if (tree_.kind(array) != Kind::array)
    return error(array, ErrorCode::bad_syntax, "expected an array of points [x, y]");
  Points ring;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (ring.size() > max_vertices)  // one more may close the ring
      return error(i, ErrorCode::too_many_vertices, no_more_vertices);
    const Result<Vec2> at = position(i);
    if (!at) return at.error();
    ring.push_back(*at);
  }
  return ring;
}

std::optional<InputError> GeojsonReader::take_hole(Index ring, Document& document) {
  if (document.holes.size() == sink_.most_holes())
    return error(ring, ErrorCode::too_many_vertices, no_more_holes);
  Result<Points> hole = this->ring(ring);
  if (!hole) return hole.error();
  if (hole->empty()) return error(ring, ErrorCode::too_few_vertices, no_vertices_of_hole);
  document.holes.push_back(std::move(hole).value());
  return std::nullopt;
}

// Capitals do not matter in names.
std::optional<std::string> GeojsonReader::name_in(Index object, std::string_view member) const {
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    if (!same_word(tree_.name(i), member)) continue;
    if (tree_.kind(i) == Kind::string) return std::string(tree_.text(i));
    if (tree_.kind(i) == Kind::number) return shortest(tree_.number(i));
  }
  return std::nullopt;
}

std::string GeojsonReader::name_of(Index feature, std::string_view table) const {
  const auto properties = tree_.member(feature, table);
  for (const char* name : {"name", "title", "id", "objectid", "fid"}) {
    std::optional<std::string> found;
    if (is(properties, Kind::object)) found = name_in(*properties, name);
    if (!found && std::string_view(name) == "id") found = name_in(feature, name);
    if (found) return *std::move(found);
  }
  return "";
}

void GeojsonReader::polygon(Index rings, std::string_view name, const Document& of) {
  if (tree_.kind(rings) != Kind::array)
    return sink_.add_problem(
        error(rings, ErrorCode::bad_syntax, "expected an array of rings of positions [x, y]"));
  const Index first = tree_.first(rings);
  if (first == tree_.end(rings))
    return sink_.add_problem(error(rings, ErrorCode::too_few_vertices, no_vertices));
  Result<Points> ring = this->ring(first);
  if (!ring) return sink_.add_problem(ring.error());
  if (ring->empty())
    return sink_.add_problem(error(first, ErrorCode::too_few_vertices, no_vertices));
  Document document = of;
  document.vertices = std::move(ring).value();
  for (Index i = tree_.next(first); i != tree_.end(rings); i = tree_.next(i))
    if (auto wrong = take_hole(i, document)) return sink_.add_problem(*std::move(wrong));
  notes_.drop_repeated(document.vertices);
  for (Points& hole : document.holes) notes_.drop_repeated(hole);
  sink_.add(std::move(document), name, "polygon");
}

void GeojsonReader::geometry(Index object, std::string_view name, const Document& of) {
  const auto type = tree_.member(object, "type");
  const auto coordinates = tree_.member(object, "coordinates");
  if (!is(type, Kind::string))
    return sink_.add_problem(error(object, ErrorCode::bad_syntax, "the geometry has no \"type\""));
  const std::string_view kind = tree_.text(*type);
  if (kind == "Polygon" || kind == "MultiPolygon") {
    if (!coordinates)
      return sink_.add_problem(
          error(*type, ErrorCode::bad_syntax, say("the {kind} has no \"coordinates\"", {kind})));
    if (kind == "Polygon" || !is(coordinates, Kind::array)) return polygon(*coordinates, name, of);
    for (Index i = tree_.first(*coordinates); i != tree_.end(*coordinates); i = tree_.next(i))
      polygon(i, name, of);
  } else if (kind == "GeometryCollection") {
    const auto all = tree_.member(object, "geometries");
    if (!is(all, Kind::array))
      return sink_.add_problem(
          error(*type, ErrorCode::bad_syntax, "the GeometryCollection has no \"geometries\""));
    for (Index i = tree_.first(*all); i != tree_.end(*all); i = tree_.next(i))
      geometry(i, name, of);
  } else {
    sink_.leave_out(kind, std::string(kind) + "s");
  }
}

void GeojsonReader::feature(Index object) {
  Document with_centre;
  const auto properties = tree_.member(object, "properties");
  const auto centre =
      is(properties, Kind::object) ? tree_.member(*properties, "centre_of_mass") : std::nullopt;
  if (centre && !is(centre, Kind::null)) {
    const Result<Vec2> at = position(*centre);
    if (!at)
      return sink_.add_problem(
          error(*centre, ErrorCode::bad_syntax, "\"centre_of_mass\" is not [x, y]"));
    with_centre.centre_of_mass = *at;
  }
  if (centre) of_evenlift_ = true;
  const auto shape = tree_.member(object, "geometry");
  if (!is(shape, Kind::object))
    return sink_.leave_out("feature without a geometry", "features without a geometry");
  geometry(*shape, name_of(object, "properties"), with_centre);
}

void GeojsonReader::object(Index object, std::string_view name, const Document& of) {
  if (sink_.full()) return;
  const auto type = tree_.member(object, "type");
  if (tree_.is_string(type, "FeatureCollection")) {
    const auto features = tree_.member(object, "features");
    if (!is(features, Kind::array))
      return sink_.add_problem(
          error(*type, ErrorCode::bad_syntax, "the FeatureCollection has no \"features\""));
    for (Index i = tree_.first(*features); i != tree_.end(*features); i = tree_.next(i))
      this->object(i, "", {});
  } else if (tree_.is_string(type, "Feature")) {
    feature(object);
  } else {
    geometry(object, name, of);
  }
}

void GeojsonReader::take(Index object, std::string_view name) { this->object(object, name, {}); }

void GeojsonReader::take_all() {
  take(tree_.root(), "");
  if (!is_in_degrees()) return;
  notes_.are_degrees = true;
  notes_.in_degrees =
      "by the standard of GeoJSON its coordinates are degrees of longitude and latitude, not "
      "lengths";
}

// By the standard the coordinates are degrees, unless the text names another reference system, as
// older GeoJSON does.
bool GeojsonReader::is_in_degrees() const {
  const auto system = tree_.member(0, "crs");
  if (of_evenlift_) return false;
  if (!is(system, Kind::object)) return true;
  const auto properties = tree_.member(*system, "properties");
  const auto name = is(properties, Kind::object) ? tree_.member(*properties, "name") : std::nullopt;
  if (!is(name, Kind::string)) return false;
  const std::string_view text = tree_.text(*name);
  const std::size_t colon = text.rfind(':');
  const std::string_view code = colon == std::string_view::npos ? text : text.substr(colon + 1);
  return code == "CRS84" || evenlift::is_in_degrees(read_number(code).value_or(0));
}

}  // namespace evenlift
