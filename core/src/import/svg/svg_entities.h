// Entities that an SVG declares for itself: <!ENTITY plate "<rect … />">.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

// The text with the values of its own entities in their places; empty if it declares none. Entities
// of other files are left as they are. It is an error if entities contain each other more than eight
// deep, or if the text becomes longer than 64 MiB. O(the longer text).
Result<std::optional<std::string>> with_entities(std::string_view text);

}  // namespace evenlift
