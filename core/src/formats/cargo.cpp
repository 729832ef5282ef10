#include "formats/readers.h"
#include "numbers/utf8.h"

namespace evenlift {
namespace {

// Of ASCII, or U+0080 to U+009F.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7f;
  return byte(0) == 0xc2 && byte(1) < 0xa0;
}

}  // namespace

const char* fault_of_cargo_weight(double weight) {
  static_assert(min_weight == 1e-100 && max_weight == 1e100, "the message names the numbers");
  return weight >= min_weight && weight <= max_weight
             ? nullptr
             : "the weight of cargo must be a number greater than 0, from 1e-100 to 1e100";
}

const char* fault_of_cargo_name(std::string_view name) {
  static_assert(max_name_characters == 60, "the message names the number");
  for (std::size_t characters = 0; !name.empty(); ++characters) {
    const std::size_t length = utf8_length(name);
    if (length == 0) return "the name of cargo must be valid UTF-8";
    if (is_control(name.substr(0, length)))
      return "the name of cargo must have no control characters";
    if (characters == max_name_characters)
      return "the name of cargo must have at most 60 characters";
    name.remove_prefix(length);
  }
  return nullptr;
}

}  // namespace evenlift
