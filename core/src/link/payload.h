// Turns a Document into the digits of a share link, and back (docs/link-format.md). Any change of
// the format makes a new version.
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "evenlift/document.h"
#include "link/range_coder.h"

namespace evenlift {

// Version 2 is version 1, followed by records (records.h).
enum class LinkVersion : std::uint8_t { one = 1, two = 2 };

// The least version for the document. O(1).
LinkVersion version_for(const Document& document);

// Returns the shortest of a few encodings. All numbers must be finite, the settings within their
// ranges, and the vertices at most max_link_vertices in number. O(n).
Digits encode_payload(const Document& document);

// The two reasons why digits are not a document: no encoding gives them, or a later program wrote a
// record with this unknown tag.
struct NoPayload {};
struct UnknownRecord {
  unsigned tag = 0;
};
using Payload = std::variant<Document, NoPayload, UnknownRecord>;

// Reads the digits. In a document, all numbers are finite and there are at most max_link_vertices
// vertices. Work and memory are bounded for any digits. O(digits).
Payload decode_payload(LinkVersion version, std::span<const std::uint8_t> digits);

}  // namespace evenlift
