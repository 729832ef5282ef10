// Converts between numbers and texts, with the same results on every platform and in every locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace evenlift {

// The number `digits` * 10^`exponent`, with a sign. The digits do not end in 0; zero is 0 * 10^0.
struct Decimal {
  std::uint64_t digits;  // below 10^17
  int exponent;
  bool negative;
};

// The decimal with the fewest digits that reads back as the same double. If there are several, it
// is the one nearest to the value. The value must be finite. O(1).
Decimal shortest_decimal(double value);

// Appends the text of shortest() (numbers.h). The value must be finite. O(1).
void append_shortest(std::string& text, double value);

// A number at the beginning of a text.
struct ScannedNumber {
  enum class Kind { none, finite, too_large };
  Kind kind;
  std::size_t length;  // in bytes; 0 for Kind::none
  double value;        // the nearest double, ties to even; may be -0 or subnormal
};

// Reads the longest prefix of the text that is a number: an optional sign, one or more digits with
// at most one decimal point, and an optional exponent ("-1.5e3", ".5", "5."). Spaces, hexadecimal
// digits, infinity and NaN are not part of a number. O(bytes).
ScannedNumber scan_number(std::string_view text);

// --- Characters in UTF-8.

// The number of bytes in the text's first character; 0 if the text is empty or does not begin with
// a valid UTF-8 character. O(1).
std::size_t utf8_length(std::string_view text);

// Whether the line is UTF-8 without control characters other than tabs and carriage returns.
// O(bytes).
bool is_line_of_text(std::string_view line);

}  // namespace evenlift
