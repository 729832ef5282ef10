// The characters of links: their digits, their checksum, and what is said of both.
// docs/link-format.md, "Text", specifies them.
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

// The end of the link that begins at `begin`, in a text that ends at `end`. Anything appended to an
// address after '&', such as parameters of visit counters, is not part of the link; nor is
// punctuation or a closing bracket of the surrounding text. The full stop after the version is.
std::size_t end_of_link(std::string_view text, std::size_t begin, std::size_t end);

// The value 0 .. 63 of a character of the alphabet.
std::optional<std::uint8_t> digit_of(char c);

// An error whose place is the link, and the character if it is not 0.
InputError link_error(ErrorCode code, std::string message, std::size_t character = 0);

// The error for the character at `at`, which a link cannot contain.
InputError bad_character(std::string_view text, std::size_t at);

// Completes a link that so far is its version: appends the digits and the checksum. O(digits).
void append_digits(std::string& link, const Digits& digits);

// The digits from `payload` to the checksum of the link [begin, end) in a text, or why they cannot
// be right. O(end - begin).
Result<Digits> read_digits(std::string_view text, std::size_t begin, std::size_t payload,
                           std::size_t end);

}  // namespace evenlift
