// Buttons return true when pressed. `id` is unique within the window, and `about` is the tip. A
// disabled button is drawn faintly and does nothing.
#pragma once

#include <string>

#include "ui/icons.h"
#include "ui/ui.h"
#include "widgets/area.h"

namespace evenlift::view {

bool icon_button(const Ui& ui, const char* id, Icon icon, bool enabled, const char* about,
                 float size, Pressed on = {});
bool text_button(const Ui& ui, const char* id, Icon icon, const char* label, const char* about,
                 float height, Icon after = Icon::none, Pressed on = {});

float text_button_width(const char* label);  // with an icon before the label

// A button with its own background. A strong button stands out as the next action. `spoken` is the
// name for users who cannot see the button's surroundings, if it differs from the label.
bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled = true,
                 bool strong = false, const char* spoken = nullptr);

// A button that stays down while `on`.
bool toggle_button(const Ui& ui, const char* id, const char* label, const char* about, float width,
                   bool on);

// A switch with a label.
bool switch_chip(const Ui& ui, const char* label, bool on);
float switch_chip_width(const char* label);

// A pressable row at Dear ImGui's cursor; the caller draws the row.
struct PressableRow {
  ImVec2 low, high;
  bool pressed, hovered;
};
PressableRow pressable_row(const Ui& ui, const char* id, const std::string& label, float width,
                           float height, bool enabled = true);

}  // namespace evenlift::view
