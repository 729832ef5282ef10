// The settings on which robots and their loads depend, as text for the page's workers.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/settings.h"

namespace evenlift::view {

// A setting's line `name=value`, as read_lines() reads it; empty if the setting has no text.
std::string setting_line(Setting setting, const Document& document);

// The lines of all these settings, including the centre of mass.
std::string settings_text(const Document& document);

// Reads lines `name=value` into the document. Returns false at the first invalid one. O(bytes).
bool read_lines(std::string_view lines, Document& document);

}  // namespace evenlift::view
