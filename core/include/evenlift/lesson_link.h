// Links to lessons (docs/link-format.md, "Lessons"): the text of a lesson, compressed, as
// `L1.PAYLOAD` in characters that a URL need not escape. An address holds it after its `#`, alone
// or after the link of a document and an `&`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

inline constexpr std::size_t max_lesson_bytes = 1u << 16;  // of the text of a lesson

// The link to a lesson with this text, without the `#`. It is an error if the text is longer than
// max_lesson_bytes; nothing else is checked. A lesson of 1,500 bytes takes about 750
// characters. Every platform makes the same link. O(bytes).
Result<std::string> encode_lesson_link(std::string_view lesson);

// The text of the lesson of a link, byte for byte. The argument is the link, or a whole address
// that contains it; white space around it is ignored. Every byte string gives a text or an error,
// whose place is the link. The text need not be a lesson: parse_lesson() (lesson.h) decides that.
// O(bytes + max_lesson_bytes).
Result<std::string> decode_lesson_link(std::string_view text);

// Whether a text contains a link to a lesson, perhaps a damaged one or one of a later version: an
// L, digits and a full stop, at the beginning of the text or after a `#` or `&`. O(bytes).
bool has_lesson_link(std::string_view text);

}  // namespace evenlift
