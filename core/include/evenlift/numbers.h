// Numbers as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace evenlift {

// The fewest digits that read back as the same double, in the format of ECMAScript: "0.1", "-5",
// "1e+30", with an exponent from 1e21 up and below 1e-6. Of equally short decimals, the nearest is
// used. Unlike ECMAScript, -0 is "-0.0", not "0". The value must be finite. The text is the same on
// every platform. O(1).
std::string shortest(double value);

// The double nearest to a decimal number, perhaps with a sign, point and exponent, without spaces.
// All formats of evenlift use this syntax. Nothing for any other text, such as infinity, NaN,
// hexadecimal, or a number that overflows. O(bytes).
std::optional<double> read_number(std::string_view text);

// A whole number of at most 2^64 - 1, in digits only; nothing for any other text. O(bytes).
std::optional<std::uint64_t> read_whole(std::string_view text);

}  // namespace evenlift
