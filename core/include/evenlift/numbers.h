// Numbers as text: read to the nearest double, and written with the fewest digits that read back to
// the same double.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace evenlift {

// The fewest digits that read back to the same double, of those the nearest, as ECMAScript writes
// numbers and JSON reads them: "0.1", "-5", "1e+30"; an exponent from 1e21 up and below 1e-6. Only
// -0 is not "0" but "-0.0". The value must be finite. Same on every platform. O(1).
std::string shortest(double value);

// The number that the whole text is, in the syntax of all our formats: a decimal number with an
// optional sign, point and exponent, no spaces; none for anything else, infinity, NaN, hexadecimal,
// or what overflows. O(bytes).
std::optional<double> read_number(std::string_view text);

// The whole number of at most 2^64 - 1 that the text is: digits only. O(bytes).
std::optional<std::uint64_t> read_whole(std::string_view text);

}  // namespace evenlift
