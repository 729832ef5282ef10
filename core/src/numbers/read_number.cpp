#include "evenlift/numbers.h"
#include "numbers/number_text.h"

namespace evenlift {

std::optional<double> read_number(std::string_view text) {
  const ScannedNumber number = scan_number(text);
  if (number.kind != ScannedNumber::Kind::finite || number.length != text.size())
    return std::nullopt;
  return number.value;
}

std::optional<std::uint64_t> read_whole(std::string_view text) {
  if (text.empty()) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    const auto digit = static_cast<std::uint64_t>(c - '0');
    if (value > (~std::uint64_t{0} - digit) / 10) return std::nullopt;
    value = 10 * value + digit;
  }
  return value;
}

}  // namespace evenlift
