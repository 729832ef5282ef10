// The settings of a document as members of a JSON object, from the table of settings.
#pragma once

#include <vector>

#include "evenlift/output/json_text.h"
#include "evenlift/settings.h"

namespace evenlift::json {

// Adds the settings from `first` to `last` in a list (SettingRow::in_document, in_result) that
// affect the document's method, in the order of Setting. O(output).
void add_settings(std::vector<Member>& members, const Document& document, Listed SettingRow::*list,
                  Setting first, Setting last);

std::string overlays(const Overlays& overlays);
std::string robot(const RobotSize& robot);

}  // namespace evenlift::json
