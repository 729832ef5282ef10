// A document's settings as members of a JSON object.
#pragma once

#include <vector>

#include "evenlift/output/json_text.h"
#include "evenlift/settings.h"

namespace evenlift::json {

// Adds the settings from `first` to `last` that the document's method uses and that `list` selects
// (SettingRow::in_document or in_result), in the order of Setting. O(output).
void add_settings(std::vector<Member>& members, const Document& document, Listed SettingRow::*list,
                  Setting first, Setting last);

std::string overlays(const Overlays& overlays);
std::string robot(const RobotSize& robot);

}  // namespace evenlift::json
