// Writes loads and robustness for a placement's JSON, at nesting level `depth`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/output/json_text.h"
#include "evenlift/report.h"
#include "evenlift/settings.h"

namespace evenlift::json {

std::string number_or_null(const std::optional<double>& value);

// The member that is this quantity, and the members of this object that are quantities.
Member quantity(std::string_view name, const Reported& of);
std::vector<Member> quantities_of(std::string_view object, const Reported& of);

std::string robots(const Placement& placement, int depth);

std::string models(const std::optional<ModelLoads>& models, int depth);

std::string ranges(const std::vector<LoadRange>& ranges);

// What the readings tell; the object must have been weighed.
std::string weighing(const Reported& of, int depth);

// Includes the ranges of the loads if there is a disturbance.
std::string robustness(const Reported& of, const std::optional<ModelLoads>& models, int depth);

// If there is a disturbance, includes for each failure RestOfRobots::stays, and the greatest load
// within the disturbance.
std::string failures(const Report& report, int depth);

std::string accuracy(const Reported& of, int depth);
std::string tilt(const std::optional<Tilt>& tilt, int depth);
std::string extra(const std::optional<ExtraLoad>& extra, double weight, int depth);

// --- A document's settings as members of a JSON object.

// Adds the settings from `first` to `last` that the document's method uses and that `list` selects
// (SettingRow::in_document or in_result), in the order of Setting. O(output).
void add_settings(std::vector<Member>& members, const Document& document, Listed SettingRow::*list,
                  Setting first, Setting last);

std::string overlays(const Overlays& overlays);
std::string robot(const RobotSize& robot);

}  // namespace evenlift::json
