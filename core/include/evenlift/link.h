// Share links (docs/link-format.md): a Document as the text `VERSION.PAYLOAD`, in characters that a
// URL need not escape.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// The link of a document, without the `#`. It holds every coordinate bit for bit, and leaves out
// settings that are at their defaults. It is an error if there are more than max_link_vertices
// vertices, if a number is not finite, if a coordinate exceeds max_coordinate or if a setting is
// outside its range (of the weight only if it is not above 0), or if the link would be longer than
// max_link_bytes; nothing else is checked. What version 1 can hold is written as version 1.
// Settings that only version 2 has are left out if the method does not use them. Every platform
// makes the same link. O(n).
Result<std::string> encode_link(const Document& document);

// The document of a link. The text is the link, with or without a `#` before it, or a whole address
// that ends with one; white space around it is ignored, and so is an `&` with all that follows,
// which others append to addresses. Every byte string gives a document or an error. The error's
// place is the link, and the character at fault if there is one, counted from 1. Every version ever
// written can be read. Bounded by max_link_bytes and max_link_vertices. O(bytes).
Result<Document> decode_link(std::string_view text);

// Whether a text looks like a share link rather than a polygon or a path: perhaps an address and a
// `#`, then digits, a dot, and nothing but characters of links. A percent-escaped link counts, too,
// so that decode_link can report it. A path such as "1.txt" also looks like a link. O(bytes).
bool looks_like_link(std::string_view text);

}  // namespace evenlift
