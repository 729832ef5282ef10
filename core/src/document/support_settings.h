// The places and capacities of supports, from text and to text (supports_text() of settings.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Reads a list (list_text.h) such as "0,0 160,0@30 80,90", or "none". Returns whether the text is
// valid, and changes the document only then: its supports, their capacities and, if there are
// supports, the method. O(bytes).
bool read_supports(std::string_view text, Document& document);

// The first item that read_supports() cannot read, as from refused_item() (list_text.h). O(bytes).
std::string_view refused_support(std::string_view text);

// read_capacities() reads a list such as "30,none,40", or an empty text for no capacities. It
// returns whether the text is valid, and changes the capacities only then. capacities_text() writes
// such a text. O(bytes).
using Capacities = std::vector<std::optional<double>>;
bool read_capacities(std::string_view text, Capacities& capacities);
std::string capacities_text(const Capacities& capacities);

// Whether there are no capacities, or at most most_supports of which at least one is given and all
// given ones are in their range. O(capacities).
bool are_capacities(const Capacities& capacities);

}  // namespace evenlift
