// True when pressed. `id` is unique within the window. A disabled button is drawn faintly and does
// nothing.
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

float text_button_width(const char* label);  // with an icon before it

// With its own background; a strong button stands out as the next thing to do. `spoken` is its name
// for users who cannot see its surroundings, if different.
bool flat_button(const Ui& ui, const char* id, const char* label, float width, bool enabled = true,
                 bool strong = false, const char* spoken = nullptr);

// Stays down while `on`.
bool toggle_button(const Ui& ui, const char* id, const char* label, const char* about, float width,
                   bool on);

// A switch with a name.
bool switch_chip(const Ui& ui, const char* label, bool on);
float switch_chip_width(const char* label);

// At the cursor; the caller draws the row.
struct PressableRow {
  ImVec2 low, high;
  bool pressed, hovered;
};
PressableRow pressable_row(const Ui& ui, const char* id, const std::string& label, float width,
                           float height, bool enabled = true);

}  // namespace evenlift::view
