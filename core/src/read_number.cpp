#include "evenlift/formats.h"
#include "number_text.h"

namespace evenlift {

std::optional<double> read_number(std::string_view text) {
  const ScannedNumber number = scan_number(text);
  if (number.kind != ScannedNumber::Kind::finite || number.length != text.size())
    return std::nullopt;
  return number.value;
}

}  // namespace evenlift
