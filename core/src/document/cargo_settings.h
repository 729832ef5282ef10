// The cargo, from text and to text (cargo_text() of settings.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Reads a list (list_text.h) such as "8,8:24 2,3:1.5:motor 0,0:3:\"a box\"", or "none". In quotes,
// a quote is doubled. Returns whether the text is valid, and changes the cargo only then. O(bytes).
bool read_cargo(std::string_view text, std::vector<Cargo>& cargo);

// See refused_item() (list_text.h). O(bytes).
std::string_view refused_cargo(std::string_view text);

// Why the weight or name of cargo is refused; nullptr if it is not. A name is UTF-8 without control
// characters, at most max_name_characters. O(bytes).
const char* fault_of_cargo_weight(double weight);
const char* fault_of_cargo_name(std::string_view name);

// Whether there are at most max_cargo items, each at a place within max_coordinate, with its weight
// in its range and a name. O(bytes of names).
bool is_cargo(const std::vector<Cargo>& cargo);

}  // namespace evenlift
