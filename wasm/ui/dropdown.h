// A button that opens a list of choices below itself.
#pragma once

#include <string>

#include "ui/widgets.h"

namespace evenlift::view {

// The list for a popup opened with ImGui::OpenPopup(id): below `anchor_low` .. `anchor_high`. If it
// is open returns true; then add rows and call end_choices().
bool begin_choices(const Ui& ui, const char* id, ImVec2 anchor_low, ImVec2 anchor_high,
                   float least_width);
// One choice, with a word about it; true when chosen.
bool choice(const Ui& ui, const std::string& label, const char* about, bool current);
void end_choices(const Ui& ui);

// The button of a setting, as wide as `width`; pressed, it opens the popup `id`.
void dropdown_button(const Ui& ui, const char* id, const std::string& label, float width);

}  // namespace evenlift::view
