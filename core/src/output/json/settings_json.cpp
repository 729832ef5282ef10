#include "output/json/settings_json.h"

namespace evenlift::json {
namespace {

bool is_of_use(const SettingRow& row, const Settings& settings) {
  if (row.setting == Setting::goal)
    return swaps_teams(settings) || (settings.method == Method::balanced && settings.goal);
  return is_kept(row, settings);
}

std::string capacities(const std::vector<std::optional<double>>& given) {
  std::vector<std::string> items;
  for (const std::optional<double>& capacity : given)
    items.push_back(capacity ? number(*capacity) : "null");
  return array(items);
}

std::string cargo(const std::vector<Cargo>& cargo) {
  std::vector<std::string> items;
  for (const Cargo& item : cargo) {
    std::vector<Member> members{{"at", pair(item.at)}, {"weight", number(item.weight)}};
    if (!item.name.empty()) members.push_back({"name", text(item.name)});
    items.push_back(object(members));
  }
  return long_array(items, 1);
}

std::string value(const SettingRow& row, const Document& document) {
  switch (row.setting) {
    case Setting::overlays:
      return overlays(document.shown.overlays);
    case Setting::robot:
      return robot(document.settings.robot);
    case Setting::goal:
      return text(name(goal_of(document.settings)));
    case Setting::supports:
      return points(document.settings.supports, 1);
    case Setting::cargo:
      return cargo(document.settings.cargo);
    case Setting::support_capacities:
      return capacities(document.shown.support_capacities);
    default:
      break;
  }
  const std::string given = text_of(row.setting, document);
  if (!row.access.is_number) return text(given);
  if (given.empty() || given == "none") return "null";
  return given == row.range.unset ? text(given) : given;
}

}  // namespace

void add_settings(std::vector<Member>& members, const Document& document, Listed SettingRow::*list,
                  Setting first, Setting last) {
  const Document usual;
  for (const SettingRow& row : all_settings()) {
    if (row.setting < first || row.setting > last || row.*list == Listed::never) continue;
    if (!is_of_use(row, document.settings)) continue;
    if (row.*list == Listed::if_changed &&
        text_of(row.setting, document) == text_of(row.setting, usual))
      continue;
    members.push_back({row.json.empty() ? row.name : row.json, value(row, document)});
  }
}

std::string overlays(const Overlays& overlays) {
  std::vector<Member> members;
  for (const NamedOverlay& overlay : all_overlays())
    members.push_back({overlay.name, boolean(overlays.*(overlay.shown))});
  return object(members);
}

std::string robot(const RobotSize& robot) {
  return object({{"radius", number(robot.radius)},
                 {"reach", number(robot.reach)},
                 {"depth", number(robot.depth)},
                 {"width", number(robot.width)},
                 {"gap", number(robot.gap)}});
}

}  // namespace evenlift::json
