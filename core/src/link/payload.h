// A Document as the digits of a share link, and back (docs/link-format.md). Any change makes a new
// version.
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "evenlift/document.h"
#include "link/range_coder.h"

namespace evenlift {

// Version 2 is version 1 and then records (records.h).
enum class LinkVersion : std::uint8_t { one = 1, two = 2 };

// The least version for the document. O(1).
LinkVersion version_for(const Document& document);

// The shortest of a few encodings. All numbers must be finite, settings within their ranges, and
// vertices at most max_link_vertices. O(n).
Digits encode_payload(const Document& document);

// Why digits are no document: no encoding gives them, or a later program wrote a record with this
// tag.
struct NoPayload {};
struct UnknownRecord {
  unsigned tag = 0;
};
using Payload = std::variant<Document, NoPayload, UnknownRecord>;

// All numbers are finite, with at most max_link_vertices vertices. Work and memory are bounded for
// any digits. O(digits).
Payload decode_payload(LinkVersion version, std::span<const std::uint8_t> digits);

}  // namespace evenlift
