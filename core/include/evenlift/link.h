// Share links (docs/link-format.md): a Document as the text `VERSION.PAYLOAD`, in characters that a
// URL need not escape.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// The link of a document, without the `#`. It holds every coordinate bit for bit, and omits
// settings that have their defaults. It is an error if there are more than max_link_vertices
// vertices or max_holes holes, if a hole has no vertices, if a number is not finite, if a
// coordinate exceeds max_coordinate, if a setting is outside its range, if the moved robots are not
// as Moved (document.h) requires, or if the link would be longer than max_link_bytes. The object's
// weight, the common capacity, `apart` and `com_radius` may have any value above 0. Nothing else is
// checked. A document that version 1 can hold is written as version 1. Settings that only version 2
// has are omitted if the method does not use them. Every platform makes the same link. O(n).
Result<std::string> encode_link(const Document& document);

// The document of a link. The text is the link, optionally with a leading `#`, or a whole address
// that ends with one. White space around it is ignored, as is an `&` with everything after it,
// which other programs append to addresses. Every byte string gives a document or an error. The
// error's place is the link, and the character at fault if there is one, counted from 1. Every
// version ever written can be read. Bounded by max_link_bytes and max_link_vertices. O(bytes).
Result<Document> decode_link(std::string_view text);

// Whether a text looks like a share link rather than a polygon or a path: optionally an address and
// a `#`, then digits, a dot, and only characters of links. A percent-escaped link also counts, so
// that decode_link() can report it. A path such as "1.txt" also looks like a link. O(bytes).
bool looks_like_link(std::string_view text);

}  // namespace evenlift
