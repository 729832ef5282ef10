#include "widgets/fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "ui/icons.h"
#include "widgets/buttons.h"
#include "widgets/text.h"

namespace evenlift::view {

Area area(const Ui& ui, ImVec2 size, Control control) {
  Area a;
  const bool enabled = control.enabled;
  a.pressed = tapped(ui, ImGui::InvisibleButton(control.name.c_str(), size)) && enabled;
  a.low = ImGui::GetItemRectMin();
  a.high = ImGui::GetItemRectMax();
  a.hovered = ImGui::IsItemHovered() && enabled;
  a.active = ImGui::IsItemActive() && enabled;
  a.asked = list_control(std::move(control));
  a.pressed |= a.asked.pressed;
  if (a.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  return a;
}

Control button_control(const char* id, const char* label, bool enabled) {
  Control control;
  control.name = id;
  control.label = label;
  control.enabled = enabled;
  return control;
}

Control toggle_control(const char* id, const char* label, bool on) {
  Control control = button_control(id, label);
  control.kind = ControlKind::toggle;
  control.on = on;
  return control;
}

Control pressed_control(const char* id, const char* label, bool enabled, Pressed on) {
  if (!on) return button_control(id, label, enabled);
  Control control = toggle_control(id, label, *on);
  control.enabled = enabled;
  return control;
}

Control number_control(const char* id, const char* label, const char* setting,
                       const std::string& value, const std::string& exact) {
  Control control = button_control(id, label);
  control.kind = ControlKind::number;
  control.setting = setting;
  if (const auto known = setting_from_name(setting)) control.is_length = row_of(*known).is_length;
  control.value = value;
  control.exact = exact;
  return control;
}

Control slider_control(const char* id, const char* label, double at, double low, double high,
                       double step) {
  Control control = button_control(id, label);
  control.kind = ControlKind::slider;
  control.at = at;
  control.low = low;
  control.high = high;
  control.step = step;
  return control;
}

namespace {

// When pressed, and repeatedly while held.
bool repeats(const Ui& ui, const Area& a) {
  if (!a.active) return a.pressed && ImGui::GetIO().MouseDownDurationPrev[0] < 0.35f;
  const ImGuiIO& io = ImGui::GetIO();
  ui.push(LayOutAgain{});
  const float held = io.MouseDownDuration[0];
  if (held < 0.35f) return false;
  constexpr float every = 0.09f;
  return std::floor(held / every) > std::floor((held - io.DeltaTime) / every);
}

void draw_ground(const Ui& ui, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
  list.AddRect(low, high, ui.theme.quiet.packed(), 7, 0, 1);
}

}  // namespace

int stepper(const Ui& ui, const char* id, const std::string& value, float width,
            const StepperOptions& options) {
  const float height = ui.control(), side = height + 4;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(id);
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + height);
  list.AddRectFilled(low, high, ui.theme.well.packed(), 7);
  int change = 0;
  const auto end = [&](const char* sign, const char* words, Icon icon, bool enabled, int by) {
    const std::string name = std::string(id) + ' ' + sign, label = say(words, {options.label});
    const Area a =
        area(ui, ImVec2(side, height), button_control(name.c_str(), label.c_str(), enabled));
    if (a.hovered || a.active) list.AddRectFilled(a.low, a.high, ui.theme.panel_line.packed(), 7);
    draw_icon(list, icon, a.middle(), 16, enabled ? ui.theme.text : ui.theme.quiet.at(0.6f));
    if (enabled && (a.asked.pressed || repeats(ui, a))) change = by;
  };
  end("-", "{setting}: less", Icon::minus, options.can_lower, -1);
  ImGui::SameLine(0, 0);
  const float middle = width - 2 * side;
  ImGui::Dummy(ImVec2(middle, height));
  if (*options.setting)
    list_control(number_control(id, options.label, options.setting, value, options.exact));
  ImGui::SameLine(0, 0);
  end("+", "{setting}: more", Icon::plus, options.can_raise, 1);
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(list, Face::strong,
            ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2), ui.theme.text,
            value);
  ImGui::PopID();
  return change;
}

void text_field(const Ui& ui, const char* id, const char* label, const char* setting,
                const std::string& value, float width, const std::string& exact) {
  constexpr float pad = 10;
  ImGui::Dummy(ImVec2(width, ui.control()));
  list_control(number_control(id, label, setting, value, exact));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  draw_ground(ui, low, high);
  draw_text(*ImGui::GetWindowDrawList(), Face::text,
            ImVec2(low.x + pad, (low.y + high.y - text_size(Face::text, value).y) / 2),
            ui.theme.text, cut_off(Face::text, value, width - 2 * pad));
}

void number_field(const Ui& ui, const char* id, const char* label, const char* setting,
                  const std::string& value, float width, Colour colour, const std::string& exact) {
  ImGui::Dummy(ImVec2(width, ui.control()));
  list_control(number_control(id, label, setting, value, exact));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 text = text_size(Face::strong, value);
  draw_text(*ImGui::GetWindowDrawList(), Face::strong,
            ImVec2(high.x - text.x, (low.y + high.y - text.y) / 2), colour, value);
}

Asked typed_field(const Ui& ui, const TypedField& field, const std::string& value, float width) {
  const ImVec2 name = text_size(Face::label, field.label), from = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, Face::label, ImVec2(from.x, from.y + (ui.control() - name.y) / 2),
            ui.theme.second_text, field.label);
  ImGui::SetCursorScreenPos(ImVec2(from.x + name.x + 6, from.y));
  ImGui::Dummy(ImVec2(width, ui.control()));
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
               text = text_size(Face::strong, value);
  draw_ground(ui, low, high);
  draw_text(list, Face::strong,
            ImVec2((low.x + high.x - text.x) / 2, (low.y + high.y - text.y) / 2), ui.theme.text,
            value);
  Control control = number_control(field.id, field.label, "", value);
  control.is_length = field.is_length;
  return list_control(std::move(control));
}

float knob_radius(const Ui& ui) { return ui.control() > 40 ? 11.0f : 8.0f; }
SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, bool counts) {
  const Track even{[=](double at) { return (at - low) / (high - low); },
                   [=](double share) { return low + share * (high - low); }};
  return slider(ui, id, label, value, low, high, step, width, even, counts);
}

SliderResult slider(const Ui& ui, const char* id, const char* label, double value, double low,
                    double high, double step, float width, const Track& track, bool counts) {
  const Colour ink = counts ? ui.theme.accent : ui.theme.quiet;
  const float height = ui.control(), knob = knob_radius(ui);
  const Area a = area(ui, ImVec2(width, height), slider_control(id, label, value, low, high, step));
  SliderResult result{false, ImGui::IsItemDeactivated(), value};
  if (a.asked.moved && *a.asked.moved >= low && *a.asked.moved <= high)
    result = {*a.asked.moved != value, true, *a.asked.moved};
  take_way_of_finger();
  const float from = a.low.x + knob, to = a.high.x - knob;
  if (a.active && ImGui::IsMouseDown(0)) {
    const double share =
        std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from) / (to - from)), 0.0, 1.0);
    // Steps are decimals: a quotient of integers is the double nearest to the shown decimal.
    const double steps = std::round(1 / step);
    const double at = track.value(share);
    const double wanted =
        step < 1 ? std::round(at * steps) / steps : std::min(std::round(at / step) * step, high);
    result.changed = wanted != value;
    result.value = wanted;
  }
  const float x = from + (to - from) * static_cast<float>(track.share(result.value)),
              y = a.middle().y;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(a.high.x, y + 3), ui.theme.quiet.packed(), 3);
  list.AddRectFilled(ImVec2(a.low.x, y - 3), ImVec2(x, y + 3), ink.packed(), 3);
  if (a.hovered || a.active)
    list.AddCircleFilled(ImVec2(x, y), knob + 5, ui.theme.accent.at(0.16f).packed(), 32);
  list.AddCircleFilled(ImVec2(x, y), knob, ui.theme.panel.packed(), 32);
  list.AddCircle(ImVec2(x, y), knob, ink.packed(), 32, 2);
  return result;
}

RowOfPlaces row_of_places(const Ui& ui, const char* id, const char* label, const std::string& value,
                          std::size_t count, std::optional<std::size_t> taken, ImVec2 size) {
  const double at = taken ? static_cast<double>(*taken) + 1 : 0, most = static_cast<double>(count);
  Control control = slider_control(id, label, at, 0, most, 1);
  control.value = value;
  control.enabled = count > 0;
  const Area a = area(ui, size, std::move(control));
  take_way_of_finger();
  RowOfPlaces row{a.low, a.high, {}, taken};
  if (count == 0) return row;
  if (a.asked.moved && *a.asked.moved >= 0 && *a.asked.moved <= most) {
    const auto place = static_cast<std::size_t>(std::round(*a.asked.moved));
    row.taken = place > 0 ? std::optional(place - 1) : std::nullopt;
    return row;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const float share = std::clamp((io.MousePos.x - a.low.x) / size.x, 0.0f, 1.0f);
  const auto under =
      std::min(count - 1, static_cast<std::size_t>(static_cast<double>(share) * most));
  if (a.hovered || a.active) row.hovered = under;
  const bool slid = is_dragged();
  if (a.active && slid) row.taken = under;
  if (a.pressed && !slid) row.taken = taken == under ? std::nullopt : std::optional(under);
  return row;
}

}  // namespace evenlift::view
