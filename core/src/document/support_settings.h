// Reads the places and capacities of supports from text, and writes the capacities. supports_text()
// (settings.h) writes the places.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Reads "none" or a list (list_text.h) of supports x,y or x,y@capacity, such as "0,0 160,0@30".
// Returns whether the text is valid. If so, sets the document's supports, their capacities and, if
// there are supports, its method; otherwise changes nothing. O(bytes).
bool read_supports(std::string_view text, Document& document);

// The first item that is not a valid support, as refused_item() (list_text.h) returns it. O(bytes).
std::string_view refused_support(std::string_view text);

// read_capacities() reads a list such as "30,none,40", or an empty text for no capacities. It
// returns whether the text is valid, and changes the capacities only if it is. capacities_text()
// writes such a text. O(bytes).
using Capacities = std::vector<std::optional<double>>;
bool read_capacities(std::string_view text, Capacities& capacities);
std::string capacities_text(const Capacities& capacities);

// Whether `capacities` is empty, or has at most most_supports entries of which at least one is set
// and all that are set are in range. O(capacities).
bool are_capacities(const Capacities& capacities);

}  // namespace evenlift
