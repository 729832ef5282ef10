// Share links (docs/link-format.md): a Document as `VERSION.PAYLOAD`, in characters that need no
// escaping in a URL.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// The link of a document, without `#`: coordinates bit for bit, settings that are at their default
// take no room. Refuses more than max_link_vertices, non-finite numbers, coordinates beyond
// max_coordinate and settings outside their ranges; nothing else is checked. The same document
// gives the same link on every platform. O(n).
Result<std::string> encode_link(const Document& document);

// The document of a link: the fragment, with or without `#`, or a whole address that ends in one;
// white space around it does not matter. Total: any byte string gives a document or an error, whose
// place is the link and, if it is one character's fault, that one, counted from 1. Reads every
// version ever written. Bounded by max_link_bytes and max_link_vertices. O(bytes).
Result<Document> decode_link(std::string_view text);

// Whether a text looks like a share link rather than a polygon or a path: an optional address and
// `#`, then digits, a dot and link characters only; also if it was percent-escaped, so that
// decode_link can say so. A path such as "1.txt" looks like a link, too. O(bytes).
bool looks_like_link(std::string_view text);

}  // namespace evenlift
