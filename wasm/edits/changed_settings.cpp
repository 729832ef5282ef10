#include "edits/changed_settings.h"

#include <optional>

#include "evenlift/settings.h"

namespace evenlift::view {
namespace {

bool differs(const SettingRow& row, const Document& a, const Document& b) {
  return text_of(row.setting, a) != text_of(row.setting, b);
}

}  // namespace

bool stand_alike(const Settings& a, const Settings& b) {
  const Document before{{}, {}, a}, after{{}, {}, b};
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::stands && differs(row, before, after)) return false;
  return true;
}

Edit edit_between(const Document& before, const Document& after) {
  std::optional<Edit> only;
  for (const SettingRow& row : all_settings()) {
    const bool centre = row.setting == Setting::com;
    if ((row.edit.empty() && !centre) || !differs(row, before, after)) continue;
    const Edit edit = !centre                ? edit_of(row)
                      : after.centre_of_mass ? Edit::centre_moved
                                             : Edit::centre_released;
    if (only.value_or(edit) != edit) return Edit::settings;
    only = edit;
  }
  return only.value_or(Edit::settings);
}

Shown with_changes(const Shown& shown, const Shown& before, const Shown& after) {
  Document changed{{}, {}, {}, shown};
  const Document from{{}, {}, {}, before}, to{{}, {}, {}, after};
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::shown && row.setting != Setting::step && differs(row, from, to))
      read_setting(row.setting, text_of(row.setting, to), changed);
  return changed.shown;
}

}  // namespace evenlift::view
