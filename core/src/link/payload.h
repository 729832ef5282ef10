// The payload of share links: a Document as digits, and back. docs/link-format.md specifies the
// format. No version ever changes; any change makes a new version.
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "evenlift/document.h"
#include "link/range_coder.h"

namespace evenlift {

// Version 2 is version 1 followed by records (records.h).
enum class LinkVersion : std::uint8_t { one = 1, two = 2 };

// The least version that can represent the document. O(1).
LinkVersion version_for(const Document& document);

// Writes the document in a few encodings and returns the shortest result. All its numbers must be
// finite, its settings within their ranges, and its vertices at most max_link_vertices. O(n).
Digits encode_payload(const Document& document);

// The reason why digits are not a document: encode_payload could not have written them in any
// encoding, or a later program wrote a record with this tag.
struct NoPayload {};
struct UnknownRecord {
  unsigned tag = 0;
};
using Payload = std::variant<Document, NoPayload, UnknownRecord>;

// All numbers of the returned document are finite, and it has at most max_link_vertices vertices.
// Work and memory are bounded for any digits. O(digits).
Payload decode_payload(LinkVersion version, std::span<const std::uint8_t> digits);

}  // namespace evenlift
