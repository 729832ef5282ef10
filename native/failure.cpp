#include "failure.h"

namespace evenlift::native {

Failure bad_input(const std::string& source, const InputError& error) {
  const std::string place = describe(error.place);
  // A place in a link already says so: "link, character 5".
  const bool alone = error.place.kind == Place::Kind::link;
  const std::string where = place.empty() ? source : alone ? place : source + ": " + place;
  return {bad_input_status, where, error.message};
}

}  // namespace evenlift::native
