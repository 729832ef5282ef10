// Writes and reads numbers as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace evenlift {

// Returns the fewest digits that read back as the same double, in the format of ECMAScript: "0.1",
// "-5", "1e+30", with an exponent from 1e21 up and below 1e-6. If several decimals are equally
// short, the nearest is used. Unlike ECMAScript, -0 is "-0.0", not "0". The value must be finite.
// The text is the same on every platform. O(1).
std::string shortest(double value);

// Returns the double nearest to a decimal number, which may have a sign, a point and an exponent,
// but no spaces. All formats of evenlift use this syntax. It returns nothing for any other text,
// such as infinity, NaN, hexadecimal, or a number that overflows. O(bytes).
std::optional<double> read_number(std::string_view text);

// Reads a whole number of at most 2^64 - 1, in digits only; returns nothing for any other text.
// O(bytes).
std::optional<std::uint64_t> read_whole(std::string_view text);

}  // namespace evenlift
