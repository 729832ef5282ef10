#include "widgets/area.h"

#include <utility>

#include "evenlift/settings.h"
#include "widgets/cards.h"

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

}  // namespace evenlift::view
