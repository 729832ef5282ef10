#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"

namespace evenlift {
namespace {

const char* name(ErrorCode code) {
  switch (code) {
    case ErrorCode::too_few_vertices:
      return "too_few_vertices";
    case ErrorCode::too_many_vertices:
      return "too_many_vertices";
    case ErrorCode::bad_coordinate:
      return "bad_coordinate";
    case ErrorCode::repeated_vertex:
      return "repeated_vertex";
    case ErrorCode::no_area:
      return "no_area";
    case ErrorCode::edges_cross:
      return "edges_cross";
    case ErrorCode::object_too_small:
      return "object_too_small";
    case ErrorCode::centre_outside_hull:
      return "centre_outside_hull";
    case ErrorCode::bad_setting:
      return "bad_setting";
    case ErrorCode::hole_outside:
      return "hole_outside";
    case ErrorCode::too_many_edge_pairs:
      return "too_many_edge_pairs";
    case ErrorCode::bad_syntax:
      return "bad_syntax";
    case ErrorCode::unsupported:
      return "unsupported";
    case ErrorCode::text_too_long:
      return "text_too_long";
    case ErrorCode::bad_link:
      return "bad_link";
    case ErrorCode::bad_checksum:
      return "bad_checksum";
    case ErrorCode::unknown_version:
      return "unknown_version";
  }
  return "";
}

// One or two vertices or edges, from 0, and their rings unless both are on the outline.
std::string place_json(const Place& place) {
  const std::string index = std::to_string(place.index), other = std::to_string(place.other);
  const bool two = place.other != 0 && place.other != place.index;
  const bool in_holes = place.ring != 0 || place.other_ring != 0;
  const bool pair = two || place.ring != place.other_ring;
  const auto both = [&](const char* name) {
    std::vector<json::Member> members{
        {name, json::array(pair ? std::vector{index, other} : std::vector{index})}};
    const std::string ring = std::to_string(place.ring), second = std::to_string(place.other_ring);
    if (in_holes)
      members.push_back(
          {"rings", json::array(pair ? std::vector{ring, second} : std::vector{ring})});
    return json::object(members);
  };
  switch (place.kind) {
    case Place::Kind::nowhere:
      break;
    case Place::Kind::line:
      return json::object({{"line", index}, {"column", other}});
    case Place::Kind::vertex:
      return both("vertices");
    case Place::Kind::edge:
      return both("edges");
    case Place::Kind::hole:
      return json::object({{"rings", json::array({std::to_string(place.ring)})}});
    case Place::Kind::centre_of_mass:
      return json::object({{"centre_of_mass", "true"}});
    case Place::Kind::option:
      return json::object({{"setting", json::text(place.option)}});
    case Place::Kind::link:
      return json::object({{"character", index}});
  }
  return "null";
}

}  // namespace

std::string error_json(const InputError& error) {
  return json::object({{"code", json::text(name(error.code))},
                       {"message", json::text(sentence(error))},
                       {"place", place_json(error.place)}});
}

}  // namespace evenlift
