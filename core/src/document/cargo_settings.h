// Reads cargo from text and checks it. cargo_text() (settings.h) writes it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Reads "none" or a list (list_text.h) of items x,y:weight or x,y:weight:name, such as
// "8,8:24 0,0:3:\"a box\"". A quotation mark within a quoted name is doubled. Returns whether the
// text is valid, and changes the cargo only if it is. O(bytes).
bool read_cargo(std::string_view text, std::vector<Cargo>& cargo);

// The first item that is not valid cargo, as refused_item() (list_text.h) returns it. O(bytes).
std::string_view refused_cargo(std::string_view text);

// The reason why a weight or a name of cargo is refused; nullptr if it is valid. A name must be
// UTF-8 without control characters and have at most max_name_characters. O(bytes).
const char* fault_of_cargo_weight(double weight);
const char* fault_of_cargo_name(std::string_view name);

// Whether there are at most max_cargo items, each with coordinates of at most max_coordinate in
// size, a valid weight and a valid name. O(bytes of names).
bool is_cargo(const std::vector<Cargo>& cargo);

}  // namespace evenlift
