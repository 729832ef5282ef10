// The cargo, from text and to text (cargo_text() of settings.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Reads a list (list_text.h) such as "8,8:24 2,3:1.5:motor 0,0:3:\"a box\"", or "none". A quote
// within quotes is doubled. Returns whether the text is valid, and changes the cargo only then.
// O(bytes).
bool read_cargo(std::string_view text, std::vector<Cargo>& cargo);

// The first item that read_cargo() cannot read, as from refused_item() (list_text.h). O(bytes).
std::string_view refused_cargo(std::string_view text);

// Why the weight or the name of cargo is refused; nullptr if it is valid. A name must be UTF-8
// without control characters and have at most max_name_characters. O(bytes).
const char* fault_of_cargo_weight(double weight);
const char* fault_of_cargo_name(std::string_view name);

// Whether there are at most max_cargo items, each with coordinates of at most max_coordinate in
// size, a valid weight and a valid name. O(bytes of names).
bool is_cargo(const std::vector<Cargo>& cargo);

}  // namespace evenlift
