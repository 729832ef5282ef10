#include "evenlift/result.h"

namespace evenlift {
namespace {

std::string hole(std::size_t ring) { return "hole " + std::to_string(ring); }

// "vertex 3", "vertices 3 and 7" if the place names two, "hole 2, vertex 3", or "hole 2, vertex 3
// and the outline's vertex 7".
std::string one_or_two(const std::string& one, const std::string& two, const Place& place) {
  const std::string first = std::to_string(place.index + 1),
                    second = std::to_string(place.other + 1);
  const std::string where = place.ring == 0 ? "" : hole(place.ring) + ", ";
  if (place.ring != place.other_ring)
    return where + one + " " + first + " and " +
           (place.other_ring == 0 ? "the outline's " : hole(place.other_ring) + ", ") + one + " " +
           second;
  if (place.other == 0 || place.other == place.index) return where + one + " " + first;
  return where + two + " " + first + " and " + second;
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
    case Place::Kind::hole:
      return hole(place.ring);
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
