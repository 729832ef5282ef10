#include "panels/length_row.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "panels/panels.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// Below the first step, a length is 0.
double stepped_length(const AppState& state, double length, int by) {
  const double first = first_length(size_of_object(state));
  if (by > 0) return length < first ? first : stepped(length, by);
  const double lower = length > 0 ? stepped(length, by) : 0;
  return lower < first ? 0 : lower;
}

void push(const Ui& ui, Setting setting, const Document& changed) {
  if (row_of(setting).changes == Changes::shown)
    ui.push(SetShown{changed.shown});
  else
    ui.push(SetSettings{changed.settings});
}

}  // namespace

double size_of_object(const AppState& state) {
  return state.derived().placement ? state.derived().placement->polygon().diagonal() : 100;
}

double first_length(double size_of_object) {
  return std::pow(10.0, std::floor(std::log10(size_of_object / 50)));
}

bool draw_optional(const Ui& ui, const OptionalRow& row) {
  const SettingRow& setting = row_of(row.setting);
  const std::string id(setting.name);
  Document changed{{}, {}, settings(ui.state), shown(ui.state)};
  const std::optional<double> value = read_number(text_of(row.setting, changed));
  const float width = labelled(ui, row.label, row.about), clear = ui.control();
  if (!value) {
    text_field(ui, id.c_str(), row.spoken.c_str(), id.c_str(), row.without, width);
    return false;
  }
  const Units& units = shown(ui.state).units;
  const int by = stepper(
      ui, id.c_str(),
      setting.is_length ? with_length_unit(plain(*value), units) : given_weight(*value, units),
      width - clear - 4,
      {.can_lower = *value > 1e-3,
       .can_raise = *value < 1e9,
       .label = row.spoken.c_str(),
       .setting = id.c_str(),
       .exact = shortest(*value)});
  ImGui::SameLine(0, 4);
  const bool unsets = icon_button(ui, row.unset_id, Icon::close, true, row.unset, clear);
  if (unsets || by != 0) {
    read_setting(row.setting,
                 unsets ? std::string(setting.range.unset) : shortest(stepped(*value, by)),
                 changed);
    push(ui, row.setting, changed);
  }
  return true;
}

void draw_length(const Ui& ui, const LengthRow& row) {
  Document changed{{}, {}, settings(ui.state), shown(ui.state)};
  const std::optional<double> length = read_number(text_of(row.setting, changed));
  const std::string setting(name(row.setting)),
      value = length ? with_length_unit(plain(*length), shown(ui.state).units) : "default";
  std::string id = setting;
  std::replace(id.begin(), id.end(), '_', ' ');
  const bool resets = row.member && length;
  const float width = labelled(ui, row.label, row.about), reset = resets ? ui.control() : 0;
  const int by = stepper(ui, id.c_str(), value, width - reset,
                         {.can_lower = length.value_or(1) > 0,
                          .can_raise = length.value_or(0) < max_length,
                          .label = row.spoken,
                          .setting = setting.c_str()});
  if (resets) {
    ImGui::SameLine(0, 0);
    if (icon_button(ui, ("usual " + id).c_str(), Icon::close, true, row.usual, reset)) {
      (changed.settings.*row.member).reset();
      return push(ui, row.setting, changed);
    }
  }
  if (by == 0) return;
  read_setting(row.setting, shortest(stepped_length(ui.state, length.value_or(0), by)), changed);
  push(ui, row.setting, changed);
}

}  // namespace evenlift::view
