// The kinds of rows in drawers, and the numbers that they step.
#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "panels/drawers.h"
#include "panels/panels.h"
#include "widgets/buttons.h"
#include "widgets/fields.h"
#include "widgets/text.h"

namespace evenlift::view {
namespace {

// 100 goes up to 110, down to 99.
double step_for(double value, int direction) {
  const double below = value * (direction < 0 ? 0.999999 : 1);
  return std::pow(10.0, std::floor(std::log10(std::max(below, 1e-6))) - 1);
}

double stepped_length(const AppState& state, double length, int by) {
  // Ten steps of this length, then tenths of the length: 10, 20, ... 100, 110.
  const double first = first_length(size_of_object(state)), steps = length / first,
               whole = std::round(steps);
  if (steps > 10 || (by > 0 && whole >= 10)) return stepped(length, by);
  const bool is_whole = std::abs(steps - whole) < 1e-9;
  const double next = std::max(0.0, by > 0 ? (is_whole ? whole : std::floor(steps)) + 1
                                           : (is_whole ? whole : std::ceil(steps)) - 1);
  return first >= 1 ? next * first : next / std::round(1 / first);
}

std::optional<double> number_of(const AppState& state, Setting setting) {
  return read_number(text_of(setting, state.work.document()));
}

void change(const Ui& ui, Setting setting, const std::string& text) {
  Document changed{{}, {}, settings(ui.state), shown(ui.state)};
  read_setting(setting, text, changed);
  if (row_of(setting).changes == Changes::shown)
    ui.push(SetShown{changed.shown});
  else
    ui.push(SetSettings{changed.settings});
}

const char* spoken(const DrawerRow& row) { return row.spoken ? row.spoken : row.label; }

}  // namespace

double size_of_object(const AppState& state) {
  return state.derived().placement ? state.derived().placement->polygon().diagonal() : 100;
}

double first_length(double size_of_object) {
  return std::pow(10.0, std::floor(std::log10(size_of_object / 50)));
}

double stepped(double value, int by) {
  const double step = step_for(value, by);
  const double steps = std::round(value / step) + by;
  return step >= 1 ? steps * step : steps / std::round(1 / step);
}

std::string length_text(const AppState& state, double value) {
  return with_length_unit(plain(value), shown(state).units);
}

std::string weight_text(const AppState& state, double value) {
  return given_weight(value, shown(state).units);
}

void draw_remark(const Ui& ui, const std::string& text, std::size_t lines) {
  text_block_of(Face::label, ui.theme.second_text, text, ImGui::GetContentRegionAvail().x, lines);
}

void draw_text(const Ui& ui, const DrawerRow& row) {
  const std::string id(name(*row.setting));
  const float width = labelled(ui, row.label, row.about);
  text_field(ui, id.c_str(), spoken(row), id.c_str(),
             text_of(*row.setting, ui.state.work.document()), width);
}

void draw_length(const Ui& ui, const DrawerRow& row) {
  const std::optional<double> length = number_of(ui.state, *row.setting);
  const std::string setting(name(*row.setting)),
      id = id_of(*row.setting), value = length ? length_text(ui.state, *length) : "default";
  const bool resets = row.member && length;
  const float width = labelled(ui, row.label, row.about), reset = resets ? ui.control() : 0;
  const int by = stepper(ui, id.c_str(), value, width - reset,
                         {.can_lower = length.value_or(1) > 0,
                          .can_raise = length.value_or(0) < max_length,
                          .label = spoken(row),
                          .setting = setting.c_str()});
  if (resets) {
    ImGui::SameLine(0, 0);
    if (icon_button(ui, ("usual " + id).c_str(), Icon::close, true, row.usual, reset)) {
      Settings changed = settings(ui.state);
      (changed.*row.member).reset();
      return ui.push(SetSettings{changed});
    }
  }
  if (by != 0) change(ui, *row.setting, shortest(stepped_length(ui.state, length.value_or(0), by)));
}

void draw_ratio(const Ui& ui, const DrawerRow& row) {
  const SettingRange& range = row_of(*row.setting).range;
  const std::string setting(name(*row.setting)), id = id_of(*row.setting);
  const double value = number_of(ui.state, *row.setting).value_or(0);
  const int by =
      stepper(ui, id.c_str(), row.text(ui.state, value), labelled(ui, row.label, row.about),
              {.can_lower = value > range.least,
               .can_raise = value < range.most,
               .label = spoken(row),
               .setting = setting.c_str(),
               .exact = row.exact(value)});
  if (by == 0) return;
  const double steps = std::round(1 / row.step);
  change(ui, *row.setting,
         shortest(std::clamp((std::round(value * steps) + by) / steps, range.least, range.most)));
}

void draw_optional(const Ui& ui, const DrawerRow& row) {
  const SettingRow& setting = row_of(*row.setting);
  const std::string id(setting.name);
  const std::optional<double> value = number_of(ui.state, *row.setting);
  const float width = labelled(ui, row.label, row.about), clear = ui.control();
  if (!value) return text_field(ui, id.c_str(), spoken(row), id.c_str(), row.without, width);
  const int by = stepper(ui, id.c_str(), row.text(ui.state, *value), width - clear - 4,
                         {.can_lower = *value > 1e-3,
                          .can_raise = *value < 1e9,
                          .label = spoken(row),
                          .setting = id.c_str(),
                          .exact = shortest(*value)});
  ImGui::SameLine(0, 4);
  if (icon_button(ui, row.unset_id, Icon::close, true, row.unset, clear))
    change(ui, *row.setting, std::string(setting.range.unset));
  else if (by != 0)
    change(ui, *row.setting, shortest(stepped(*value, by)));
}

}  // namespace evenlift::view
