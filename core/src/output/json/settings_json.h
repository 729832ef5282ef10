// A document's settings as members of a JSON object.
#pragma once

#include <vector>

#include "evenlift/output/json_text.h"
#include "evenlift/settings.h"

namespace evenlift::json {

// From `first` to `last` of a list (SettingRow::in_document, in_result), those that affect the
// document's method, in the order of Setting. O(output).
void add_settings(std::vector<Member>& members, const Document& document, Listed SettingRow::*list,
                  Setting first, Setting last);

std::string overlays(const Overlays& overlays);
std::string robot(const RobotSize& robot);

}  // namespace evenlift::json
