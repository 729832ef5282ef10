#include "evenlift/similar_setting.h"

#include <vector>

#include "evenlift/closest_name.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"

namespace evenlift {

std::string_view similar_setting(std::string_view typed) {
  std::vector<std::string_view> names;
  for (const SettingRow& row : all_settings()) names.push_back(row.name);
  return closest_name(typed, names);
}

std::string unknown_setting(std::string_view typed) {
  const std::string_view similar = similar_setting(typed);
  return similar.empty() ? say("unknown setting")
                         : say("unknown setting; did you mean {setting}?", {similar});
}

}  // namespace evenlift
