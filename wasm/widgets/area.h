// What all controls share: a pressable area, and the entry in the list of controls.
#pragma once

#include <optional>
#include <string>

#include "ui/controls.h"
#include "ui/ui.h"

namespace evenlift::view {

// At the cursor.
struct Area {
  ImVec2 low, high;
  bool pressed, hovered, active;
  Asked asked;
  ImVec2 middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

Area area(const Ui& ui, ImVec2 size, Control control);

// For the list, by kind.
Control button_control(const char* id, const char* label, bool enabled = true);
Control toggle_control(const char* id, const char* label, bool on);
Control number_control(const char* id, const char* label, const char* setting,
                       const std::string& value, const std::string& exact = {});
Control slider_control(const char* id, const char* label, double at, double low, double high,
                       double step);

// A button stays down while `on`; without a value, never.
using Pressed = std::optional<bool>;

// A toggle if it can be on, otherwise a button.
Control pressed_control(const char* id, const char* label, bool enabled, Pressed on);

}  // namespace evenlift::view
