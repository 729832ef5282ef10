// Writes and reads numbers as text, and cells of tables.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace evenlift {

// Returns the fewest digits that read back as the same double, in the format of ECMAScript: "0.1",
// "-5", "1e+30". There is an exponent if the absolute value is at least 1e21, or below 1e-6 but not
// 0. If several decimals are equally short, the one nearest to the value is used. Unlike in
// ECMAScript, -0 is "-0.0", not "0". The value must be finite. The text is the same on every
// platform. O(1).
std::string shortest(double value);

// Returns the double nearest to a decimal number. The number may have a sign, a point and an
// exponent, but no spaces. Settings, and the formats of formats.h except GeoJSON, use this syntax.
// The function returns nothing for any other text, such as infinity, NaN or a hexadecimal number,
// and for a number that overflows. O(bytes).
std::optional<double> read_number(std::string_view text);

// Returns the value of a text that is a whole number of at most 2^64 - 1, in digits only. Returns
// nothing otherwise. O(bytes).
std::optional<std::uint64_t> read_whole(std::string_view text);

// A text as a cell in CSV (RFC 4180). An apostrophe keeps a spreadsheet from computing it. O(bytes).
std::string csv_cell(std::string text);

}  // namespace evenlift
