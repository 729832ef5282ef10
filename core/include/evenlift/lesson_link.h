// Links to lessons (docs/link-format.md, "Lessons"). A link is the compressed text of a lesson as
// `L1.PAYLOAD`, in characters that a URL need not escape. An address has the link after its `#`,
// either alone or after the link of a document and an `&`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

inline constexpr std::size_t max_lesson_bytes = 1u << 16;  // of the text of a lesson

// Returns the link of a lesson's text, without the `#`. A text longer than max_lesson_bytes is an
// error; nothing else is checked. A text of 1,500 bytes takes about 750 characters. Every platform
// makes the same link. O(bytes).
Result<std::string> encode_lesson_link(std::string_view lesson);

// Returns the text of a lesson, byte for byte, from a link or from a whole address with a link.
// White space around the link or address is ignored. Any input is allowed: the result is a text, or
// an error that gives the link as its place. parse_lesson() (lesson.h) decides whether the text is
// a lesson. O(bytes + max_lesson_bytes).
Result<std::string> decode_lesson_link(std::string_view text);

// Returns whether a text contains a link to a lesson, even a damaged link or one of a later
// version: an L, digits and a full stop, at the beginning of the text or after a `#` or `&`.
// O(bytes).
bool has_lesson_link(std::string_view text);

}  // namespace evenlift
