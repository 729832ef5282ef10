// The payload of share links of version 1: a Document as digits, and back. docs/link-format.md
// specifies the format. It is fixed for ever; any change makes a new version.
#pragma once

#include <optional>
#include <span>

#include "evenlift/document.h"
#include "link/range_coder.h"

namespace evenlift {

// Writes the document in a few encodings and returns the shortest result. All its numbers must be
// finite, it has at most max_link_vertices vertices, and its settings are within their ranges.
// O(n).
Digits encode_payload_1(const Document& document);

// The document, or nothing if encode_payload_1 could not have written these digits in any encoding.
// All numbers of the document are finite, and it has at most max_link_vertices vertices. Work and
// memory are bounded for any digits. O(digits).
std::optional<Document> decode_payload_1(std::span<const std::uint8_t> digits);

}  // namespace evenlift
