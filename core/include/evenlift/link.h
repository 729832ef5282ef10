// Share links (docs/link-format.md): a Document as the text `VERSION.PAYLOAD`, in characters that a
// URL need not escape.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// Returns the link of a document, without the `#`. The link holds every coordinate bit for bit. It
// omits settings that have their default values, and those settings of version 2 that the method
// does not use. The link is of version 1 if that version can hold the document. It is an error if
// there are more than max_link_vertices vertices or max_holes holes, a hole has no vertices, a
// number is not finite, a coordinate exceeds max_coordinate in size, a setting is out of range, the
// moved robots are not as Moved (document.h) requires, or the link would exceed max_link_bytes.
// There is no upper bound for the weight, the common capacity, `apart` and `com_radius`: any finite
// value above 0 is accepted. Nothing else is checked. Every platform makes the same link. O(n).
Result<std::string> encode_link(const Document& document);

// Returns the document of a link, which may have a leading `#` or be at the end of a whole address.
// White space around the text is ignored. An `&` and all that follows it are also ignored, since
// other programs append them to addresses. Any bytes give either a document or an error. The
// error's place is the link and, if known, the character, counted from 1. Links of every version
// ever written can be read. Time and memory are bounded, since links longer than max_link_bytes and
// polygons with more than max_link_vertices vertices are refused. O(bytes).
Result<Document> decode_link(std::string_view text);

// Returns whether a text looks like a share link rather than a polygon or a path: digits and a full
// stop, followed only by characters that links may contain. An address and a `#` may come before.
// Percent-escaped characters also count, so that decode_link() can report the escaping. A path such
// as "1.txt" also looks like a link. O(bytes).
bool looks_like_link(std::string_view text);

}  // namespace evenlift
