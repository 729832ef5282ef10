// The payload of share links of version 1: a Document to digits and back. The format is described
// in docs/link-format.md and fixed for ever; a change of it is a new version.
#pragma once

#include <optional>
#include <span>

#include "evenlift/document.h"
#include "link/range_coder.h"

namespace evenlift {

// The shortest of a few ways to write the document. All its numbers must be finite, its vertices at
// most max_link_vertices, its settings within their ranges. O(n).
Digits encode_payload_1(const Document& document);

// The document, if encode_payload_1 could have written the digits in one of its ways; then every
// number is finite and there are at most max_link_vertices vertices. Bounded work and memory for
// any digits. O(digits).
std::optional<Document> decode_payload_1(std::span<const std::uint8_t> digits);

}  // namespace evenlift
