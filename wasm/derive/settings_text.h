// The settings on which robots and their loads depend, as text between the page and its workers.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/settings.h"

namespace evenlift::view {

// The line `name=value` of a setting, as read_lines() reads it; empty for a setting without a text.
std::string setting_line(Setting setting, const Document& document);

// The lines of all settings on which robots or their loads depend, including the centre of mass.
std::string settings_text(const Document& document);

// Whether every line is `name=value` with a valid value; if so, changes the document accordingly.
// O(bytes).
bool read_lines(std::string_view lines, Document& document);

}  // namespace evenlift::view
