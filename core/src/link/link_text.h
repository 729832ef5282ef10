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

// The end of the link from `begin` in a text up to `end`. It excludes what follows '&' in an
// address, such as parameters of visit counters, and punctuation and closing brackets around the
// link, but not the full stop after the version.
std::size_t end_of_link(std::string_view text, std::size_t begin, std::size_t end);

// 0 .. 63.
std::optional<std::uint8_t> digit_of(char c);

// The error's place is the link, and the character if it is not 0.
InputError link_error(ErrorCode code, std::string message, std::size_t character = 0);

// A link cannot contain the character at `at`.
InputError bad_character(std::string_view text, std::size_t at);

// `link` is its version so far: appends the digits and the checksum. O(digits).
void append_digits(std::string& link, const Digits& digits);

// The digits from `payload` to the checksum of the link [begin, end), or why they cannot be right.
// O(end - begin).
Result<Digits> read_digits(std::string_view text, std::size_t begin, std::size_t payload,
                           std::size_t end);

}  // namespace evenlift
