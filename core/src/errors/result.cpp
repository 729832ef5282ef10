#include "evenlift/result.h"

namespace evenlift {
namespace {

// "vertex 3", or "vertices 3 and 7" if the place names two.
std::string one_or_two(const char* one, const char* two, const Place& place) {
  const std::string first = std::to_string(place.index + 1);
  if (place.other == 0 || place.other == place.index) return one + (" " + first);
  return two + (" " + first) + " and " + std::to_string(place.other + 1);
}

}  // namespace

InputError bad_setting(std::string name, std::string why) {
  return {ErrorCode::bad_setting, std::move(why), {Place::Kind::option, 0, 0, std::move(name)}};
}

std::string describe(const Place& place) {
  switch (place.kind) {
    case Place::Kind::nowhere:
      return {};
    case Place::Kind::line:
      return "line " + std::to_string(place.index) +
             (place.other == 0 ? std::string() : ", column " + std::to_string(place.other));
    case Place::Kind::vertex:
      return one_or_two("vertex", "vertices", place);
    case Place::Kind::edge:
      return one_or_two("edge", "edges", place);
    case Place::Kind::centre_of_mass:
      return "centre of mass";
    case Place::Kind::option:
      return place.option;
    case Place::Kind::link:
      return place.index == 0 ? "link" : "link, character " + std::to_string(place.index);
  }
  return {};
}

}  // namespace evenlift
