// The digits and checksum of links, and messages about both (docs/link-format.md, "Text").
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "evenlift/document.h"
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

// --- Turns a Document into the digits of a share link, and back (docs/link-format.md). Any change of
// the format makes a new version.

// Version 2 is version 1, followed by records (records.h).
enum class LinkVersion : std::uint8_t { one = 1, two = 2 };

// The least version that can represent the document. O(bytes of the records).
LinkVersion version_for(const Document& document);

// Returns the shortest of a few encodings. All numbers must be finite and all settings within their
// ranges, and there must be at most max_link_vertices vertices. O(n).
Digits encode_payload(const Document& document);

// Digits that do not encode any document.
struct NoPayload {};
// Digits with a record whose tag is unknown; presumably a later program wrote it.
struct UnknownRecord {
  unsigned tag = 0;
};
using Payload = std::variant<Document, NoPayload, UnknownRecord>;

// Reads the digits. In a document, all numbers are finite and there are at most max_link_vertices
// vertices. Work and memory are bounded for any digits. O(digits).
Payload decode_payload(LinkVersion version, std::span<const std::uint8_t> digits);

}  // namespace evenlift
