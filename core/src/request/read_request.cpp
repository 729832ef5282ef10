#include "request/read_request.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/similar_setting.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

using Kind = JsonTree::Kind;
using Index = JsonTree::Index;
using Problem = std::optional<InputError>;

using Names = RequestKind::Names;

// `members` are allowed next to "command".
struct CommandEntry {
  std::string_view name;
  Command command;
  Names members;
};
constexpr CommandEntry commands[] = {
    {"place",
     Command::place,
     {"polygon", "holes", "text", "centre_of_mass", "settings", "candidates", "failures",
      "even_out", "require"}},
    {"candidates", Command::candidates, {"polygon", "holes", "text", "centre_of_mass", "settings"}},
    {"svg", Command::svg, {"polygon", "holes", "text", "centre_of_mass", "settings", "candidates"}},
    {"poses",
     Command::poses,
     {"polygon", "holes", "text", "centre_of_mass", "settings", "format", "frame", "origin"}},
    {"link", Command::link, {"polygon", "holes", "text", "centre_of_mass", "settings"}},
    {"experiment", Command::experiment, {"polygons", "settings"}},
    {"version", Command::version, {}},
};
constexpr const char* command_names =
    "the command must be place, candidates, svg, poses, link, experiment or version";

class Reader {
 public:
  Reader(std::string_view text, const JsonTree& tree) : text_(text), tree_(tree) {}

  Result<Request> read() const;
  Problem check_members(Index object, const Names& allowed) const;

 private:
  InputError error(Index at, std::string message, ErrorCode code = ErrorCode::bad_syntax) const {
    return text_error(code, std::move(message), text_, tree_.offset(at));
  }
  Problem take_command(Request& request, Names& allowed) const;
  Problem take_members(Index object, Request& request) const;
  Problem take_pose_options(Index object, Request& request) const;

  Result<Document> document(Index object) const;
  Result<Points> points(Index array) const;
  Result<Vec2> point(Index at) const;
  Problem take_holes(Index array, Document& document) const;
  Problem take_settings(Index object, Document& document) const;
  Problem take_cargo(Index array, Document& document) const;
  Result<Cargo> cargo_item(Index at) const;
  Problem take_polygons(Request& request) const;
  Problem take_experiment_settings(Request& request) const;

  Problem take_flag(Index object, std::string_view name, bool& flag) const;
  Result<std::string> string(Index at, const char* what) const;
  std::string value_text(Index at) const;
  std::optional<std::string> list_text(Index array, Setting setting) const;

  std::string_view text_;
  const JsonTree& tree_;
};

// Keeps the digits of a number: a seed may have more than a double holds.
std::string Reader::value_text(Index at) const {
  if (tree_.kind(at) == Kind::string) return std::string(tree_.text(at));
  if (tree_.kind(at) != Kind::number) return {};
  const std::size_t last = tree_.offset(at);
  std::size_t first = last;
  while (first > 0 &&
         std::string_view("0123456789+-.eE").find(text_[first - 1]) != std::string_view::npos)
    --first;
  return std::string(text_.substr(first, last + 1 - first));
}

// Supports and their capacities may be arrays: [[0, 0], [1, 0]] becomes "0,0 1,0", and [30, null]
// "30,none". Nothing if an item is of another kind.
std::optional<std::string> Reader::list_text(Index array, Setting setting) const {
  const bool points = setting == Setting::supports;
  std::string text;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    const Kind kind = tree_.kind(i);
    if (points ? kind != Kind::array || !point(i) : kind != Kind::number && kind != Kind::null)
      return std::nullopt;
    text += text.empty() ? "" : points ? " " : ",";
    if (points)
      text += value_text(tree_.first(i)) + "," + value_text(tree_.next(tree_.first(i)));
    else
      text += kind == Kind::null ? "none" : value_text(i);
  }
  return text;
}

Result<std::string> Reader::string(Index at, const char* what) const {
  if (tree_.kind(at) != Kind::string) return error(at, std::string(what) + " must be a string");
  return std::string(tree_.text(at));
}

Problem Reader::check_members(Index object, const Names& allowed) const {
  for (Index i = tree_.first(object); i != tree_.end(object); i = tree_.next(i)) {
    const std::string name(tree_.name(i));
    const bool is_command = object == tree_.root() && name == "command";
    const bool is_allowed =
        !name.empty() && std::find(allowed.begin(), allowed.end(), name) != allowed.end();
    if (!is_command && !is_allowed)
      return error(i, "there is no member \"" + name + "\" here", ErrorCode::unsupported);
    if (tree_.member(object, name) != i)
      return error(i, "the member \"" + name + "\" is given twice");
  }
  return std::nullopt;
}

Problem Reader::take_flag(Index object, std::string_view name, bool& flag) const {
  const auto at = tree_.member(object, name);
  if (!at) return std::nullopt;
  if (tree_.kind(*at) != Kind::boolean)
    return error(*at, "\"" + std::string(name) + "\" must be true or false");
  // The tree has only the last letter's offset.
  const std::size_t last = tree_.offset(*at);
  flag = last >= 3 && text_.substr(last - 3, 4) == "true";
  return std::nullopt;
}

// --- Polygons

Result<Vec2> Reader::point(Index at) const {
  double values[2] = {0, 0};
  std::size_t count = 0;
  if (tree_.kind(at) == Kind::array)
    for (Index i = tree_.first(at); i != tree_.end(at); i = tree_.next(i)) {
      if (tree_.kind(i) != Kind::number || count == 2)
        return error(i, "expected a point [x, y] of two numbers");
      values[count++] = tree_.number(i);
    }
  if (count != 2) return error(at, "expected a point [x, y] of two numbers");
  return Vec2(values[0], values[1]);
}

Result<Points> Reader::points(Index array) const {
  if (tree_.kind(array) != Kind::array)
    return error(array, "the polygon must be an array of points [x, y]");
  Points points;
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (points.size() == max_vertices)
      return error(i, "the polygon has more than 1048576 vertices", ErrorCode::too_many_vertices);
    const Result<Vec2> vertex = point(i);
    if (!vertex) return vertex.error();
    points.push_back(*vertex);
  }
  return points;
}

// The holes replace those of the text.
Problem Reader::take_holes(Index array, Document& document) const {
  if (tree_.kind(array) != Kind::array)
    return error(array, "\"holes\" must be an array of rings, each an array of points [x, y]");
  document.holes.clear();
  document.moved = {};
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (document.holes.size() == max_holes)
      return error(i, "the polygon has more than 1000 holes", ErrorCode::too_many_vertices);
    Result<Points> ring = points(i);
    if (!ring) return ring.error();
    document.holes.push_back(std::move(ring).value());
  }
  return std::nullopt;
}

Result<Document> Reader::document(Index object) const {
  const auto polygon = tree_.member(object, "polygon"), text = tree_.member(object, "text");
  if (polygon.has_value() == text.has_value())
    return error(
        object,
        "a polygon must be given either as \"polygon\", an array of points [x, y], or as \"text\"");
  Document document;
  if (polygon) {
    Result<Points> vertices = points(*polygon);
    if (!vertices) return vertices.error();
    document.vertices = std::move(vertices).value();
  } else {
    const Result<std::string> given = string(*text, "\"text\"");
    if (!given) return given.error();
    Result<Document> read = looks_like_link(*given) ? decode_link(*given) : read_polygon(*given);
    if (!read) return read.error();
    document = std::move(read).value();
  }
  if (const auto holes = tree_.member(object, "holes"))
    if (auto wrong = take_holes(*holes, document)) return *std::move(wrong);
  if (const auto centre = tree_.member(object, "centre_of_mass")) {
    document.moved = {};  // as with any setting that determines places
    if (tree_.kind(*centre) == Kind::null) {
      document.centre_of_mass.reset();
      return document;
    }
    const Result<Vec2> at = point(*centre);
    if (!at) return at.error();
    document.centre_of_mass = *at;
  }
  return document;
}

Problem Reader::take_settings(Index object, Document& document) const {
  const auto settings = tree_.member(object, "settings");
  if (!settings) return std::nullopt;
  if (tree_.kind(*settings) != Kind::object)
    return error(*settings, "\"settings\" must be an object");
  for (Index i = tree_.first(*settings); i != tree_.end(*settings); i = tree_.next(i)) {
    const std::string name(tree_.name(i));
    const auto setting = setting_from_name(name);
    if (!setting || *setting == Setting::loads || *setting == Setting::failed) {
      const std::string similar(similar_setting(name));
      return error(i,
                   "there is no setting \"" + name + '"' +
                       (similar.empty() ? "" : "; did you mean \"" + similar + "\"?"),
                   ErrorCode::bad_setting);
    }
    for (Index k = tree_.first(*settings); k != i; k = tree_.next(k))
      if (setting_from_name(tree_.name(k)) == setting)
        return error(i, "the setting \"" + name + "\" is given twice", ErrorCode::bad_setting);
  }
  // Members have no order, so the robot's size is read before its parts, and supports before their
  // capacities and the method.
  for (const bool first : {true, false})
    for (Index i = tree_.first(*settings); i != tree_.end(*settings); i = tree_.next(i)) {
      const Setting setting = *setting_from_name(tree_.name(i));
      if ((setting == Setting::robot || setting == Setting::supports) != first) continue;
      if (tree_.kind(i) == Kind::null) continue;  // as if absent
      if (setting == Setting::cargo && tree_.kind(i) == Kind::array) {
        if (auto wrong = take_cargo(i, document)) return wrong;
        continue;
      }
      const bool may_be_list =
          setting == Setting::supports || setting == Setting::support_capacities;
      const bool is_list = may_be_list && tree_.kind(i) == Kind::array;
      const auto value = is_list ? list_text(i, setting) : std::optional(value_text(i));
      if (!value) return setting_error(setting);
      if (auto wrong = read_setting(setting, *value, document)) return wrong;
    }
  return std::nullopt;
}

Result<Cargo> Reader::cargo_item(Index at) const {
  if (tree_.kind(at) != Kind::object)
    return error(at, "each item of cargo must be an object with \"at\" and \"weight\"");
  if (auto wrong = check_members(at, {"at", "weight", "name"})) return *std::move(wrong);
  Cargo item;
  const auto place = tree_.member(at, "at"), weight = tree_.member(at, "weight"),
             name = tree_.member(at, "name");
  if (!place) return error(at, "an item of cargo has no \"at\"");
  const Result<Vec2> point = this->point(*place);
  if (!point) return point.error();
  item.at = *point;
  if (!weight || tree_.kind(*weight) != Kind::number)
    return error(weight.value_or(at), "the \"weight\" of an item of cargo must be a number");
  item.weight = tree_.number(*weight);
  if (name) {
    const Result<std::string> text = string(*name, "the \"name\" of an item of cargo");
    if (!text) return text.error();
    item.name = *text;
  }
  return item;
}

// Replaces the text's cargo. Ranges are checked later, with those of other settings.
Problem Reader::take_cargo(Index array, Document& document) const {
  std::vector<Cargo>& cargo = document.settings.cargo;
  cargo.clear();
  document.moved = {};
  for (Index i = tree_.first(array); i != tree_.end(array); i = tree_.next(i)) {
    if (cargo.size() == max_cargo) return setting_error(Setting::cargo);
    const Result<Cargo> item = cargo_item(i);
    if (!item) return item.error();
    cargo.push_back(*item);
  }
  return std::nullopt;
}

Problem Reader::take_pose_options(Index object, Request& request) const {
  if (const auto at = tree_.member(object, "format")) {
    const auto format = pose_format_of_file("." + value_text(*at));
    if (!format) return error(*at, "the format of poses must be csv, json or yaml");
    request.pose_format = *format;
  }
  if (const auto at = tree_.member(object, "origin")) {
    const auto origin = pose_origin_from_name(value_text(*at));
    if (!origin) return error(*at, pose_origin_requirement);
    request.poses.origin = *origin;
  }
  if (const auto at = tree_.member(object, "frame")) {
    request.poses.frame = value_text(*at);
    if (tree_.kind(*at) != Kind::string || !is_frame_name(request.poses.frame))
      return error(*at, frame_requirement);
  }
  return std::nullopt;
}

// --- Experiments

Problem Reader::take_polygons(Request& request) const {
  const auto array = tree_.member(0, "polygons");
  if (!array || tree_.kind(*array) != Kind::array)
    return error(array.value_or(0), "an experiment needs \"polygons\", an array of objects");
  for (Index i = tree_.first(*array); i != tree_.end(*array); i = tree_.next(i)) {
    if (request.polygons.size() == max_request_polygons)
      return error(i, "there are more than 10000 polygons", ErrorCode::unsupported);
    if (tree_.kind(i) != Kind::object) return error(i, "each of \"polygons\" must be an object");
    if (auto wrong =
            check_members(i, {"name", "set", "polygon", "holes", "text", "centre_of_mass"}))
      return wrong;
    NamedPolygon polygon{"polygons", "polygon " + std::to_string(request.polygons.size() + 1),
                         document(i)};
    for (const auto& [member, into] :
         {std::pair("name", &polygon.name), std::pair("set", &polygon.set)})
      if (const auto at = tree_.member(i, member)) {
        const Result<std::string> given = string(*at, "a name");
        if (!given) return given.error();
        *into = *given;
      }
    request.polygons.push_back(std::move(polygon));
  }
  return std::nullopt;
}

Problem Reader::take_experiment_settings(Request& request) const {
  const auto settings = tree_.member(0, "settings");
  if (!settings) return std::nullopt;
  if (tree_.kind(*settings) != Kind::object)
    return error(*settings, "\"settings\" must be an object");
  if (auto wrong = check_members(*settings, {"min_ratio", "samples", "max_teams", "max_balanced"}))
    return wrong;
  experiment::ExperimentSettings& given = request.experiment;
  if (const auto at = tree_.member(*settings, "min_ratio"))
    given.min_ratio = read_number(value_text(*at)).value_or(-1);
  for (const auto& [name, into] :
       {std::pair("samples", &given.samples), std::pair("max_teams", &given.most_teams),
        std::pair("max_balanced", &given.most_balanced)})
    if (const auto at = tree_.member(*settings, name)) {
      const auto number = read_whole(value_text(*at));
      *into = static_cast<std::uint32_t>(std::min<std::uint64_t>(number.value_or(0), ~0u));
    }
  return experiment::check_settings(given);
}

// --- The whole request

Problem Reader::take_command(Request& request, Names& allowed) const {
  const auto at = tree_.member(0, "command");
  const std::string name = at ? value_text(*at) : "place";
  for (const CommandEntry& entry : commands) {
    if (entry.name != name) continue;
    request.command = entry.command;
    allowed = entry.members;
    return std::nullopt;
  }
  return error(at.value_or(0), command_names, ErrorCode::unsupported);
}

Problem Reader::take_members(Index object, Request& request) const {
  Result<Document> given = document(object);
  if (!given) return given.error();
  request.document = std::move(given).value();
  if (auto wrong = take_settings(object, request.document)) return wrong;
  if (auto wrong = take_flag(object, "candidates", request.candidates)) return wrong;
  if (auto wrong = take_flag(object, "failures", request.failures)) return wrong;
  if (auto wrong = take_flag(object, "even_out", request.even_out)) return wrong;
  if (const auto at = tree_.member(object, "require")) {
    const Result<std::string> required = string(*at, "\"require\"");
    if (!required) return required.error();
    auto conditions = read_conditions(*required);
    if (!conditions) return conditions.error();
    request.conditions = std::move(conditions).value();
  }
  return take_pose_options(object, request);
}

Result<Request> Reader::read() const {
  Request request;
  Names allowed;
  if (auto wrong = take_command(request, allowed)) return *std::move(wrong);
  if (auto wrong = check_members(0, allowed)) return *std::move(wrong);
  if (request.command == Command::version) return request;
  if (request.command == Command::experiment) {
    if (auto wrong = take_polygons(request)) return *std::move(wrong);
    if (auto wrong = take_experiment_settings(request)) return *std::move(wrong);
    return request;
  }
  if (auto wrong = take_members(0, request)) return *std::move(wrong);
  return request;
}

}  // namespace

Result<RequestReader> RequestReader::read(std::string_view text, std::size_t most) {
  if (text.size() > most)
    return InputError{ErrorCode::text_too_long,
                      "the request is longer than " + std::to_string(most >> 20) + " MiB",
                      {}};
  Result<JsonTree> tree = JsonTree::read(text);
  if (!tree) return tree.error();
  if (tree->kind(tree->root()) != Kind::object)
    return text_error(ErrorCode::bad_syntax, "a request must be a JSON object", text,
                      tree->offset(tree->root()));
  return RequestReader(text, std::move(tree).value());
}

const RequestKind* RequestReader::kind_among(std::span<const RequestKind> kinds) const {
  const auto command = tree_.member(0, "command");
  for (const RequestKind& kind : kinds)
    if (tree_.is_string(command, kind.command)) return &kind;
  return nullptr;
}

std::optional<InputError> RequestReader::check_members(const RequestKind::Names& allowed) const {
  return Reader(text_, tree_).check_members(0, allowed);
}

Result<Request> RequestReader::request() const { return Reader(text_, tree_).read(); }

std::string RequestReader::text(std::string_view name) const {
  const auto at = tree_.member(0, name);
  return at && tree_.kind(*at) == Kind::string ? std::string(tree_.text(*at)) : std::string();
}

double RequestReader::number(std::string_view name) const {
  const auto at = tree_.member(0, name);
  return at && tree_.kind(*at) == Kind::number ? tree_.number(*at)
                                               : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> RequestReader::texts(std::string_view name) const {
  std::vector<std::string> texts;
  const auto at = tree_.member(0, name);
  if (!at || tree_.kind(*at) != Kind::array) return texts;
  for (Index i = tree_.first(*at); i != tree_.end(*at); i = tree_.next(i))
    if (tree_.kind(i) == Kind::string) texts.emplace_back(tree_.text(i));
  return texts;
}

std::vector<std::pair<std::string, std::string>> RequestReader::named_texts(
    std::string_view name) const {
  std::vector<std::pair<std::string, std::string>> texts;
  const auto at = tree_.member(0, name);
  if (!at || tree_.kind(*at) != Kind::object) return texts;
  for (Index i = tree_.first(*at); i != tree_.end(*at); i = tree_.next(i))
    if (tree_.kind(i) == Kind::string) texts.emplace_back(tree_.name(i), tree_.text(i));
  return texts;
}

}  // namespace evenlift
