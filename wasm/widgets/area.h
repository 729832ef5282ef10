// The parts that all controls share: a pressable area, and the entry in the list of controls.
#pragma once

#include <optional>
#include <string>

#include "ui/controls.h"
#include "ui/ui.h"

namespace evenlift::view {

// A pressable area at Dear ImGui's cursor, in pixels.
struct Area {
  ImVec2 low, high;
  bool pressed, hovered, active;
  Asked asked;
  ImVec2 middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

// Lays out the area and lists its control.
Area area(const Ui& ui, ImVec2 size, Control control);

// Return an entry of this kind for the list of controls.
Control button_control(const char* id, const char* label, bool enabled = true);
Control toggle_control(const char* id, const char* label, bool on);
Control number_control(const char* id, const char* label, const char* setting,
                       const std::string& value, const std::string& exact = {});
Control slider_control(const char* id, const char* label, double at, double low, double high,
                       double step);

// Whether a toggle is down; nothing for a button that is not a toggle.
using Pressed = std::optional<bool>;

// Returns a toggle if `on` has a value, otherwise a button.
Control pressed_control(const char* id, const char* label, bool enabled, Pressed on);

}  // namespace evenlift::view
