#include "document/document_json.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "document/setting_values.h"
#include "evenlift/wording.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

using Kind = JsonTree::Kind;
using Index = JsonTree::Index;

// The fields that are no settings come before and after them: cargo is read after C, and moves after
// all that would undo them.
constexpr std::string_view before[] = {"polygon", "holes", "centre_of_mass", "own_centre_of_mass"};
constexpr std::string_view after[] = {"moved"};
constexpr std::size_t first_setting = std::size(before);
constexpr std::size_t moved_field =
    first_setting + static_cast<std::size_t>(Setting::end_of_settings);
constexpr std::size_t field_count = moved_field + std::size(after);

// Settings that a result tells within an object, next to what was computed with them.
struct Within {
  Setting setting;
  std::string_view object, member;
};
constexpr Within within[] = {{Setting::capacity, "capacity", "limit"},
                             {Setting::accuracy, "accuracy", "asked"},
                             {Setting::extra, "extra", "weight"},
                             {Setting::com_radius, "robustness", "com_radius"}};

constexpr char expected_point[] = "a point must be two numbers [x, y]";

bool is_teams(std::string_view name) {
  return name == "teams" || name == "requested_teams" || name == "teams_asked";
}

}  // namespace

InputError DocumentReader::error(Index at, std::string message, ErrorCode code) const {
  if (from_ == From::file) return text_error(code, std::move(message), text_, tree_.offset(at));
  return {code, std::move(message), place_of_path(tree_.path(at))};
}

std::optional<std::size_t> DocumentReader::field(std::string_view name) const {
  if (const auto at = std::find(std::begin(before), std::end(before), name); at != std::end(before))
    return static_cast<std::size_t>(at - std::begin(before));
  if (name == after[0]) return moved_field;
  const bool in_file = from_ != From::request;
  if (in_file && (is_teams(name) || name == "com")) return std::nullopt;
  for (const SettingRow& row : all_settings()) {
    if (row.changes == Changes::view) continue;
    const bool is_json_name = !row.json.empty() && row.json == name;
    const bool is_name = row.name == name || (!row.alias.empty() && row.alias == name);
    if (is_json_name || (is_name && !(in_file && !row.json.empty())))
      return first_setting + static_cast<std::size_t>(row.setting);
  }
  if (in_file && name == "robustness")
    return first_setting + static_cast<std::size_t>(Setting::com_radius);
  return std::nullopt;
}

bool DocumentReader::is_field(std::string_view name) const { return field(name).has_value(); }

DocumentReader::Problem DocumentReader::read(Index object, Document& document) {
  std::array<std::optional<Index>, field_count> found;
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const auto known = field(tree_.name(i));
    if (!known) continue;
    std::optional<Index>& first = found[*known];
    if (first && tree_.name(*first) != tree_.name(i))
      return error(i,
                   say("\"{first}\" and \"{second}\" are the same setting: give one of them",
                       {tree_.name(*first), tree_.name(i)}),
                   ErrorCode::bad_setting);
    if (first)
      return error(i, say("the setting \"{name}\" is given twice", {tree_.name(i)}),
                   ErrorCode::bad_setting);
    first = i;
  }
  constexpr auto number = [](Setting setting) {
    return first_setting + static_cast<std::size_t>(setting);
  };
  if (const auto com = found[number(Setting::com)]; com && (found[2] || found[3]))
    return error(*com, "\"com\" is another name of \"centre_of_mass\": give one of them",
                 ErrorCode::bad_setting);
  if (found[3]) found[2].reset();  // the other is with cargo
  // What evenlift wrote tells the weight and C that follow from readings.
  const auto is_given = [&](Setting setting) {
    const auto at = found[number(setting)];
    return at && tree_.kind(*at) != Kind::null;
  };
  if (is_given(Setting::readings)) {
    if (from_ != From::request)
      for (const std::size_t follows : {std::size_t{2}, std::size_t{3}, number(Setting::weight)})
        found[follows].reset();
    else if (is_given(Setting::weight))
      return error(*found[number(Setting::weight)], weight_is_weighed, ErrorCode::bad_setting);
  }
  // Supports set the method, and the size of robots comes before its parts.
  for (const std::size_t early : {number(Setting::robot), number(Setting::supports)})
    if (const auto at = std::exchange(found[early], std::nullopt))
      if (auto wrong = take(early, *at, document)) return wrong;
  for (std::size_t i = 0; i < field_count; ++i) {
    if (i == moved_field && from_ != From::request)
      if (auto wrong = take_teams(object, document)) return wrong;
    if (found[i])
      if (auto wrong = take(i, *found[i], document)) return wrong;
  }
  return std::nullopt;
}

DocumentReader::Problem DocumentReader::take(std::size_t field, Index at, Document& document) {
  if (field == 2 || field == 3) return take_centre(at, document);
  if (field == 0) {
    Result<Points> vertices = ring(at);
    if (!vertices) return vertices.error();
    document.vertices = std::move(vertices).value();
    return std::nullopt;
  }
  if (tree_.kind(at) == Kind::null) return std::nullopt;
  if (field == 1) return take_holes(at, document);
  if (field == moved_field) return take_moved(at, document);
  return take_value(row_of(static_cast<Setting>(field - first_setting)), at, document);
}

// --- Outlines

Result<Vec2> DocumentReader::point(Index at) {
  double values[3] = {0, 0, 0};
  std::size_t count = 0;
  if (tree_.kind(at) != Kind::array) return error(at, expected_point);
  for (Index i = tree_.first(at); i != tree_.end(at); i = tree_.next(i)) {
    if (tree_.kind(i) != Kind::number || count == 3) return error(at, expected_point);
    values[count++] = tree_.number(i);
  }
  if (count < 2) return error(at, expected_point);
  if (count == 3) tell("third coordinates are left out");
  return Vec2(values[0], values[1]);
}

Result<Points> DocumentReader::ring(Index array) {
  if (tree_.kind(array) != Kind::array)
    return error(array, "the vertices must be an array of points [x, y]");
  Points points;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (points.size() > max_vertices)  // one more may close the ring
      return error(array, "the polygon has more than 1048576 vertices",
                   ErrorCode::too_many_vertices);
    const Result<Vec2> vertex = point(i);
    if (!vertex) return vertex.error();
    points.push_back(*vertex);
  }
  static_assert(max_vertices == 1048576, "the message names the number");
  if (points.size() > 3 && points.front() == points.back()) {
    points.pop_back();
    tell("a last vertex that repeats the first is left out");
  }
  if (points.size() > max_vertices)
    return error(array, "the polygon has more than 1048576 vertices", ErrorCode::too_many_vertices);
  return points;
}

// They replace those of the text, and `false` leaves those out.
DocumentReader::Problem DocumentReader::take_holes(Index array, Document& document) {
  if (tree_.kind(array) == Kind::boolean && tree_.is_true(array)) return std::nullopt;
  document.holes.clear();
  document.moved = {};
  if (tree_.kind(array) == Kind::boolean) return std::nullopt;
  if (tree_.kind(array) != Kind::array)
    return error(array, "the holes must be an array of rings, each an array of points [x, y]");
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (document.holes.size() == max_holes)
      return error(array, "the polygon has more than 1000 holes", ErrorCode::too_many_vertices);
    Result<Points> hole = ring(i);
    if (!hole) return hole.error();
    if (hole->empty()) return error(i, "the hole has no vertices", ErrorCode::too_few_vertices);
    document.holes.push_back(std::move(hole).value());
  }
  static_assert(max_holes == 1000, "the message names the number");
  return std::nullopt;
}

DocumentReader::Problem DocumentReader::take_centre(Index at, Document& document) {
  document.moved = {};  // as with any setting that determines places
  document.centre_of_mass.reset();
  if (tree_.kind(at) == Kind::null) return std::nullopt;
  const Result<Vec2> centre = point(at);
  if (!centre) return centre.error();
  document.centre_of_mass = *centre;
  return std::nullopt;
}

// Comes after the settings, since they put moved robots back.
DocumentReader::Problem DocumentReader::take_moved(Index at, Document& document) const {
  auto moved = tree_.kind(at) == Kind::string ? read_moved(tree_.text(at)) : std::optional<Moved>();
  if (!moved)
    return error(at, "robots moved by hand must be written like 3:0.25,5:0.5,9:1 or 2@3:0.25/9",
                 ErrorCode::bad_setting);
  document.moved = *std::move(moved);
  return std::nullopt;
}

// --- Settings

// Keeps the digits of a number: a seed may have more than a double holds.
std::string DocumentReader::digits(Index number) const {
  const std::size_t last = tree_.offset(number);
  std::size_t first = last;
  while (first > 0 &&
         std::string_view("0123456789+-.eE").find(text_[first - 1]) != std::string_view::npos)
    --first;
  std::string text(text_.substr(first, last + 1 - first));
  // Settings that are whole numbers read digits only, whatever wrote 1e3.
  const bool plain = text.find_first_of(".eE") == std::string::npos;
  return plain || from_ == From::request ? text : shortest(tree_.number(number));
}

std::optional<std::string> DocumentReader::value_text(Index at) const {
  if (tree_.kind(at) == Kind::string) return std::string(tree_.text(at));
  if (tree_.kind(at) == Kind::number) return digits(at);
  return std::nullopt;
}

// [30, null] becomes "30,none", and ["hull", "tilt"] "hull,tilt". Nothing if an item is of another
// kind.
std::optional<std::string> DocumentReader::list_text(Index array, bool of_numbers) const {
  std::string text;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    const bool is_null = tree_.kind(i) == Kind::null, is_number = tree_.kind(i) == Kind::number;
    const auto item = of_numbers && is_null ? std::optional<std::string>("none") : value_text(i);
    if (!item || (of_numbers && !is_number && !is_null)) return std::nullopt;
    text += (i == tree_.first(array) ? "" : ",") + *item;
  }
  return text;
}

// Each overlay's name, with true or false.
DocumentReader::Problem DocumentReader::take_overlays(Index object, Document& document) const {
  const auto all = all_overlays();
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const auto overlay = std::find_if(all.begin(), all.end(), [&](const NamedOverlay& each) {
      return each.name == tree_.name(i);
    });
    const bool is_known = overlay != all.end();
    if (!is_known && from_ != From::request) continue;
    if (!is_known || tree_.kind(i) != Kind::boolean)
      return error(i, "an overlay must be true or false", ErrorCode::bad_setting);
    document.shown.overlays.*(overlay->shown) = tree_.is_true(i);
  }
  return std::nullopt;
}

DocumentReader::Problem DocumentReader::take_setting(Setting setting, Index at,
                                                     std::string_view text,
                                                     Document& document) const {
  Problem wrong = read_setting(setting, text, document);
  if (wrong) wrong = error(at, std::move(wrong->message), wrong->code);
  return wrong;
}

DocumentReader::Problem DocumentReader::take_value(const SettingRow& row, Index at,
                                                   Document& document) {
  const bool is_array = tree_.kind(at) == Kind::array, is_object = tree_.kind(at) == Kind::object;
  const Setting setting = row.setting;
  if (is_array && setting == Setting::com) return take_centre(at, document);
  if (is_array && setting == Setting::cargo) return take_cargo(at, document);
  if (is_array && setting == Setting::supports) return take_supports(at, document);
  if (is_array && setting == Setting::support_names) return take_names(at, document);
  const bool is_text = tree_.kind(at) == Kind::string;
  if (!is_text && setting == Setting::support_names)
    return error(at, requirement(setting), ErrorCode::bad_setting);
  if (!is_text && setting == Setting::cargo)
    return error(
        at,
        R"(the cargo must be an array of loads like {"at": [x, y], "weight": w, "name": "..."})",
        ErrorCode::bad_setting);
  if (!is_text && setting == Setting::supports)
    return error(
        at,
        R"(the supports must be an array of points [x, y], or of objects like {"at": [x, y], "capacity": K, "name": "..."})",
        ErrorCode::bad_setting);
  if (is_object && setting == Setting::robot) return take_robot(at, document);
  if (is_object && setting == Setting::overlays) return take_overlays(at, document);
  if (is_object)
    for (const Within& each : within)
      if (each.setting == setting) {
        const auto inside = tree_.member(at, each.member);
        // A result always has an accuracy, 0 if none was asked for.
        const bool is_unset = !inside || tree_.kind(*inside) == Kind::null ||
                              (setting == Setting::accuracy && tree_.number(*inside) == 0);
        return is_unset ? std::nullopt : take_value(row, *inside, document);
      }
  const bool of_numbers = setting == Setting::support_capacities || setting == Setting::readings ||
                          setting == Setting::readings_tilted || setting == Setting::heading;
  const bool may_be_list = of_numbers || setting == Setting::no_go || setting == Setting::overlays;
  const auto text = is_array && may_be_list ? list_text(at, of_numbers) : value_text(at);
  if (!text) return error(at, requirement(setting), ErrorCode::bad_setting);
  return take_setting(setting, at, *text, document);
}

// In a result, `teams` is a list. `requested_teams` is a number even for `max`, and 1 for balanced
// robots and supports; then `teams_asked` holds the setting.
DocumentReader::Problem DocumentReader::take_teams(Index object, Document& document) const {
  const bool one_team = is_one_team(document.settings.method);
  for (const std::string_view name : {"teams", "requested_teams", "teams_asked"}) {
    const auto at = tree_.member(object, name);
    if (!at || (one_team && name == "requested_teams")) continue;
    if (const auto text = value_text(*at))
      if (auto wrong = take_setting(Setting::teams, *at, *text, document)) return wrong;
  }
  return std::nullopt;
}

// The members are named like the settings of the robots' size, without the prefix.
DocumentReader::Problem DocumentReader::take_robot(Index object, Document& document) const {
  document.settings.robot = {};
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const auto part = setting_from_name("robot_" + std::string(tree_.name(i)));
    const auto text = value_text(i);
    if (!part || !text) return error(i, requirement(Setting::robot), ErrorCode::bad_setting);
    if (auto wrong = take_setting(*part, i, *text, document)) return wrong;
  }
  return std::nullopt;
}

DocumentReader::Problem DocumentReader::only(Index object,
                                             std::initializer_list<std::string_view> members,
                                             const char* of) const {
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const bool known = std::find(members.begin(), members.end(), tree_.name(i)) != members.end();
    if (!known) return error(i, say("{thing} has no such member", {of}), ErrorCode::bad_setting);
    if (tree_.member(object, tree_.name(i)) != i)
      return error(i, say("\"{name}\" is given twice", {tree_.name(i)}), ErrorCode::bad_setting);
  }
  return std::nullopt;
}

// {"at": [x, y], "weight": w, "name": "motor"} or [[x, y], w, "motor"]; the name may be missing.
Result<Cargo> DocumentReader::cargo_item(Index item) {
  std::optional<Index> parts[3];
  if (tree_.kind(item) == Kind::object) {
    constexpr const char* names[] = {"at", "weight", "name"};
    if (auto wrong = only(item, {"at", "weight", "name"}, "a load")) return *std::move(wrong);
    for (std::size_t i = 0; i < 3; ++i) parts[i] = tree_.member(item, names[i]);
  } else if (tree_.kind(item) == Kind::array) {
    std::size_t count = 0;
    for (Index i = tree_.first(item); i != tree_.end(item) && count < 3; i = tree_.next(i))
      parts[count++] = i;
  }
  const auto& [at, weight, name] = parts;
  if (!at || !weight)
    return error(item, R"(a load must be like {"at": [x, y], "weight": w, "name": "..."})",
                 ErrorCode::bad_setting);
  const Result<Vec2> place = point(*at);
  if (!place) return place.error();
  const bool weighs = tree_.kind(*weight) == Kind::number;
  const bool named = name && tree_.kind(*name) != Kind::null;
  if (named && tree_.kind(*name) != Kind::string)
    return error(*name, "the name of a load must be a text", ErrorCode::bad_setting);
  Cargo cargo{*place, weighs ? tree_.number(*weight) : 0,
              named ? std::string(tree_.text(*name)) : std::string()};
  if (const char* fault = fault_of_cargo_weight(cargo.weight))
    return error(*weight, fault, ErrorCode::bad_setting);
  if (const char* fault = fault_of_name(cargo.name))
    return error(*name, fault, ErrorCode::bad_setting);
  return cargo;
}

DocumentReader::Problem DocumentReader::take_cargo(Index array, Document& document) {
  std::vector<Cargo> cargo;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (cargo.size() == max_cargo)
      return error(array, requirement(Setting::cargo), ErrorCode::bad_setting);
    Result<Cargo> item = cargo_item(i);
    if (!item) return item.error();
    cargo.push_back(std::move(item).value());
  }
  document.settings.cargo = std::move(cargo);
  document.moved = {};
  return std::nullopt;
}

// A name, or null for none, as it stands in a list (setting_values.h).
Result<std::string> DocumentReader::name_item(Index item, const char* wrong) const {
  const bool is_missing = tree_.kind(item) == Kind::null;
  if (!is_missing && tree_.kind(item) != Kind::string)
    return error(item, wrong, ErrorCode::bad_setting);
  const std::string_view name = is_missing ? std::string_view() : tree_.text(item);
  if (const char* fault = fault_of_name(name)) return error(item, fault, ErrorCode::bad_setting);
  return name_text(name);
}

DocumentReader::Problem DocumentReader::take_names(Index array, Document& document) const {
  std::string text;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    const Result<std::string> name = name_item(i, requirement(Setting::support_names).data());
    if (!name) return name.error();
    text += (text.empty() ? "" : " ") + *name;
  }
  return take_setting(Setting::support_names, array, text.empty() ? "none" : text, document);
}

// [x, y] or {"at": [x, y], "capacity": K, "name": "north"}, as text: "x,y@K:north".
Result<std::string> DocumentReader::support(Index item) {
  const bool is_object = tree_.kind(item) == Kind::object;
  if (is_object)
    if (auto wrong = only(item, {"at", "capacity", "name"}, "a support")) return *std::move(wrong);
  const auto at = is_object ? tree_.member(item, "at") : item;
  if (!at)
    return error(item,
                 R"(a support must be like [x, y] or {"at": [x, y], "capacity": K, "name": "..."})",
                 ErrorCode::bad_setting);
  if (const Result<Vec2> place = point(*at); !place) return place.error();
  const Index x = tree_.first(*at);
  std::string text = digits(x) + "," + digits(tree_.next(x));
  if (!is_object) return text;
  const auto capacity = tree_.member(item, "capacity");
  if (capacity && tree_.kind(*capacity) != Kind::null) {
    if (tree_.kind(*capacity) != Kind::number ||
        !is_in_range(Setting::capacity, tree_.number(*capacity)))
      return error(*capacity, requirement(Setting::capacity), ErrorCode::bad_setting);
    text += "@" + digits(*capacity);
  }
  const auto named = tree_.member(item, "name");
  if (!named) return text;
  const Result<std::string> name = name_item(*named, "the name of a support must be a text");
  if (!name) return name.error();
  return text + ":" + *name;
}

DocumentReader::Problem DocumentReader::take_supports(Index array, Document& document) {
  std::string text;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    const Result<std::string> item = support(i);
    if (!item) return item.error();
    text += (text.empty() ? "" : " ") + *item;
  }
  return take_setting(Setting::supports, array, text, document);
}

void DocumentReader::tell(std::string_view what) {
  if (std::find(notices_.begin(), notices_.end(), what) == notices_.end())
    notices_.emplace_back(what);
}

}  // namespace evenlift
