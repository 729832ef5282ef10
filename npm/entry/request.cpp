#include "evenlift/request.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "evenlift/capacity.h"
#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/settings_text.h"

namespace evenlift {
namespace {

using Json = nlohmann::json;
using Problem = std::optional<InputError>;

struct Request {
  std::string command = "place";
  bool candidates = false, failures = false;
  Document document;
};

Problem wrong(std::string message) { return InputError{ErrorCode::bad_syntax, std::move(message), {}}; }

// Invalid UTF-8 is replaced.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// --- Errors

const char* name(ErrorCode code) {
  constexpr const char* names[] = {
      "too_few_vertices", "too_many_vertices", "bad_coordinate",   "repeated_vertex",
      "no_area",          "edges_cross",       "object_too_small", "centre_outside_hull",
      "bad_setting",      "too_many_edge_pairs", "bad_syntax",     "unsupported",
      "text_too_long",    "bad_link",          "bad_checksum",     "unknown_version"};
  return names[static_cast<std::size_t>(code)];
}

Json place_of(const Place& place) {
  Json both = Json::array({place.index});
  if (place.other != 0 && place.other != place.index) both.push_back(place.other);
  switch (place.kind) {
    case Place::Kind::line:
      return {{"line", place.index}, {"column", place.other}};
    case Place::Kind::vertex:
      return {{"vertices", both}};
    case Place::Kind::edge:
      return {{"edges", both}};
    case Place::Kind::centre_of_mass:
      return {{"centre_of_mass", true}};
    case Place::Kind::option:
      return {{"setting", place.option}};
    case Place::Kind::link:
      return {{"character", place.index}};
    case Place::Kind::nowhere:
      break;
  }
  return nullptr;
}

std::string error_json(const InputError& error) {
  return text_of({{"error",
                   {{"code", name(error.code)},
                    {"message", sentence(error)},
                    {"place", place_of(error.place)}}}});
}

// --- The polygon and its settings

std::optional<Vec2> point(const Json& value) {
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number())
    return std::nullopt;
  return Vec2(value[0].get<double>(), value[1].get<double>());
}

Problem take_polygon(const Json& members, Document& document) {
  const bool has_text = members.contains("text");
  if (has_text == members.contains("polygon") || (has_text && !members["text"].is_string()))
    return wrong("a polygon comes as \"polygon\", an array of points [x, y], or as \"text\"");
  if (has_text) {
    const auto text = members["text"].get<std::string>();
    Result<Document> read = looks_like_link(text) ? decode_link(text) : read_polygon(text);
    if (!read) return read.error();
    document = std::move(read).value();
    return std::nullopt;
  }
  if (!members["polygon"].is_array()) return wrong("the polygon is an array of points [x, y]");
  for (const Json& vertex : members["polygon"]) {
    const auto at = point(vertex);
    if (!at) return wrong("expected a point [x, y] of two numbers");
    document.vertices.push_back(*at);
  }
  return std::nullopt;
}

Problem take_centre(const Json& members, Document& document) {
  const auto given = members.find("centre_of_mass");
  if (given == members.end()) return std::nullopt;
  document.centre_of_mass = point(*given);
  if (!document.centre_of_mass && !given->is_null())
    return wrong("expected a point [x, y] of two numbers");
  return std::nullopt;
}

// A whole number keeps its digits: a seed may have more of them than a double holds.
std::string word_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  return value.is_number() ? shortest(value.get<double>()) : std::string();
}

Problem take_settings(const Json& members, Document& document) {
  const auto settings = members.find("settings");
  if (settings == members.end()) return std::nullopt;
  if (!settings->is_object()) return wrong("\"settings\" is an object");
  for (const auto& [key, value] : settings->items()) {
    const auto setting = setting_from_name(key);
    if (!setting || *setting == Setting::loads || *setting == Setting::failed)
      return InputError{ErrorCode::bad_setting, "there is no setting \"" + key + "\"", {}};
    if (value.is_null()) continue;
    if (auto error = read_setting(*setting, word_of(value), document)) return error;
  }
  return std::nullopt;
}

// --- The request

Problem take_flags(const Json& members, Request& request) {
  for (const auto& [key, flag] : {std::pair("candidates", &request.candidates),
                                  std::pair("failures", &request.failures)}) {
    const auto given = members.find(key);
    if (given == members.end()) continue;
    if (!given->is_boolean()) return wrong("\"" + std::string(key) + "\" is true or false");
    *flag = given->get<bool>();
  }
  return std::nullopt;
}

Problem check_names(const Json& members, const Request& request) {
  if (!members.is_object()) return wrong("a request is a JSON object");
  const std::string& command = request.command;
  for (const auto& [key, value] : members.items()) {
    bool known = key == "command";
    for (const char* other : {"polygon", "text", "centre_of_mass", "settings"})
      known |= key == other && command != "version";
    known |= key == "candidates" && (command == "place" || command == "svg");
    known |= key == "failures" && command == "place";
    if (!known)
      return InputError{ErrorCode::unsupported, "there is no member \"" + key + "\" here", {}};
  }
  return std::nullopt;
}

Problem read_request(const Json& members, Request& request) {
  if (members.is_object() && members.contains("command")) request.command = word_of(members["command"]);
  bool known = false;
  for (const char* command : {"place", "candidates", "svg", "link", "version"})
    known |= request.command == command;
  if (!known)
    return InputError{ErrorCode::unsupported,
                      "the command is place, candidates, svg, link or version", {}};
  if (auto error = check_names(members, request)) return error;
  if (request.command == "version") return std::nullopt;
  if (auto error = take_polygon(members, request.document)) return error;
  if (auto error = take_centre(members, request.document)) return error;
  if (auto error = take_settings(members, request.document)) return error;
  return take_flags(members, request);
}

// --- Answers

std::string candidates_of(const Placement& placement) {
  const Json whole = Json::parse(placement_json(placement, true), nullptr, false);
  return text_of({{"candidates", whole["candidates"]}});
}

std::string placed(const Request& request, Placement placement) {
  const Settings& settings = placement.settings;
  if (request.command == "candidates") return candidates_of(placement);
  if (request.command == "svg") {
    placement.settings.overlays.candidates |= request.candidates;
    const Result<std::string> link = encode_link(request.document);  // a huge polygon has none
    return text_of({{"svg", placement_svg(placement, link ? *link : std::string())}});
  }
  std::optional<CapacityInJson> capacity;
  if (settings.capacity)
    capacity = CapacityInJson{*settings.capacity, plan_capacity(placement, *settings.capacity)};
  return placement_json(placement, request.candidates, capacity,
                        {settings.com_radius, request.failures});
}

}  // namespace

std::string answer(std::string_view text) {
  if (text.size() > max_text_bytes)
    return error_json({ErrorCode::text_too_long, "the request has more than 64 MiB", {}});
  const Json members = Json::parse(text, nullptr, false);
  if (members.is_discarded()) return error_json(*wrong("the request is not valid JSON"));
  Request request;
  if (const Problem problem = read_request(members, request)) return error_json(*problem);
  if (request.command == "version") return text_of({{"version", EVENLIFT_VERSION}});
  if (request.command == "link") {
    const Result<std::string> link = encode_link(request.document);
    return link ? text_of({{"link", *link}}) : error_json(link.error());
  }
  const Result<Placement> placement = place(request.document);
  return placement ? placed(request, *placement) : error_json(placement.error());
}

}  // namespace evenlift
