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
