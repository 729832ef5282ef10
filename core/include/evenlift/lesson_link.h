// Links to lessons (docs/link-format.md, "Lessons"): the compressed text as `L1.PAYLOAD`, in
// characters that a URL need not escape. An address holds the link after its `#`, alone or after
// the link of a document and an `&`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

inline constexpr std::size_t max_lesson_bytes = 1u << 16;  // of the text of a lesson

// Returns the link, without the `#`. A text longer than max_lesson_bytes is an error; nothing else
// is checked. 1,500 bytes take about 750 characters. Every platform makes the same link. O(bytes).
Result<std::string> encode_lesson_link(std::string_view lesson);

// Returns the text, byte for byte, of a link or of a whole address with a link. White space around
// the link or address is ignored. Any bytes give either a text or an error whose place is the link.
// parse_lesson() (lesson.h) decides whether the text is a lesson. O(bytes + max_lesson_bytes).
Result<std::string> decode_lesson_link(std::string_view text);

// Returns whether a text contains a link, perhaps damaged or of a later version: an L, digits and a
// full stop, at the beginning or after a `#` or `&`. O(bytes).
bool has_lesson_link(std::string_view text);

}  // namespace evenlift
