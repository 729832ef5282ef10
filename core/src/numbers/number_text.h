// Numbers as text: the nearest double of a decimal number, and the fewest digits of a double. The
// same bits and bytes on every platform, whatever the locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace evenlift {

// A number as the decimal digits * 10^exponent; the digits do not end in 0, and zero is 0 * 10^0.
struct Decimal {
  std::uint64_t digits;  // below 10^17
  int exponent;
  bool negative;
};

// The decimal with the fewest digits that reads back to the same double, and of those the nearest.
// The value must be finite. O(1).
Decimal shortest_decimal(double value);

// Appends the number as formats.h says of shortest(). The value must be finite. O(1).
void append_shortest(std::string& text, double value);

// What a text begins with.
struct ScannedNumber {
  enum class Kind { none, finite, too_large };
  Kind kind;
  std::size_t length;  // bytes of the text that belong to the number; 0 for none
  double value;        // for finite only: the nearest double, ties to even; may be -0 or subnormal
};

// The longest beginning of the text that is a number: an optional sign, digits with at most one
// decimal point and at least one digit, and perhaps an exponent ("-1.5e3", ".5", "5."). No spaces,
// hexadecimal, infinity or NaN. O(bytes).
ScannedNumber scan_number(std::string_view text);

}  // namespace evenlift
