// The digits and checksum of links, and messages about both (docs/link-format.md, "Text").
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/result.h"
#include "link/range_coder.h"

namespace evenlift {

bool is_decimal_digit(char c);
bool is_white_space(char c);

// The end of the link that starts at `begin` in a text that ends at `end`. An '&' ends the link,
// since visit counters may add parameters to an address. Punctuation, quotation marks and closing
// brackets after the link are not part of it, but the full stop after the version is.
std::size_t end_of_link(std::string_view text, std::size_t begin, std::size_t end);

// The value 0 .. 63 of a digit; nullopt if the character is not a digit.
std::optional<std::uint8_t> digit_of(char c);

// Makes an error about a link. Its place is the character with this number, counted from 1, or the
// whole link if the number is 0.
InputError link_error(ErrorCode code, std::string message, std::size_t character = 0);

// Makes the error that says that a link cannot contain the character at `at`.
InputError bad_character(std::string_view text, std::size_t at);

// Appends the digits and the checksum to `link`, which so far holds the version. O(digits).
void append_digits(std::string& link, const Digits& digits);

// Returns the digits of the link [begin, end) between `payload` and the checksum, or an error if it
// has other characters there, is too short or does not match its checksum. O(end - begin).
Result<Digits> read_digits(std::string_view text, std::size_t begin, std::size_t payload,
                           std::size_t end);

}  // namespace evenlift
