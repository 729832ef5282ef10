// Share links (docs/link-format.md): a Document as the text `VERSION.PAYLOAD`, in characters that a
// URL need not escape.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// Returns the link of a document, without the `#`. It holds every coordinate bit for bit. It omits
// settings that have their defaults. It also omits the settings that only version 2 has, if the
// method does not use them. Version 1 is used if it can hold the document. It is an error if there
// are more than max_link_vertices vertices or max_holes holes, a hole has no vertices, a number is
// not finite, a coordinate exceeds max_coordinate, a setting is out of range, the moved robots are
// not as Moved (document.h) requires, or the link would exceed max_link_bytes. The weight, the
// common capacity, `apart` and `com_radius` may have any value above 0. Nothing else is checked.
// Every platform makes the same link. O(n).
Result<std::string> encode_link(const Document& document);

// Returns the document of a link, perhaps with a leading `#`, or of a whole address that ends with
// a link. White space around the text is ignored. An `&` and all that follows it are also ignored,
// since other programs append them to addresses. Any bytes give either a document or an error whose
// place is the link and, if known, the character, counted from 1. Every version ever written can be
// read. Time and memory are bounded, since longer links and polygons with more vertices are refused
// (max_link_bytes, max_link_vertices). O(bytes).
Result<Document> decode_link(std::string_view text);

// Returns whether a text looks like a share link rather than a polygon or a path: optionally an
// address and a `#`, then digits, a dot, and only characters of links, perhaps percent-escaped so
// that decode_link() can report it. A path such as "1.txt" also looks like a link. O(bytes).
bool looks_like_link(std::string_view text);

}  // namespace evenlift
