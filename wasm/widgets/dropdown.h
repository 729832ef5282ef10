// A button that opens a list of choices below itself.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/icons.h"
#include "ui/ui.h"

namespace evenlift::view {

// The list for a popup opened with ImGui::OpenPopup(id): below `anchor_low` .. `anchor_high`, or
// above where there is more room. If it is open returns true; then add rows and call end_choices().
bool begin_choices(const Ui& ui, const char* id, ImVec2 anchor_low, ImVec2 anchor_high,
                   float least_width);
// One choice, with a word about it; true when chosen.
bool choice(const Ui& ui, const std::string& label, const char* about, bool current,
            Icon icon = Icon::none, bool enabled = true);
void end_choices(const Ui& ui);

// A setting that is one of several: its button, `width` wide, and the list that a press opens.
// Returns which was chosen.
struct Choice {
  const char* label;
  const char* about = nullptr;
};
std::optional<std::size_t> dropdown(const Ui& ui, const char* id, const char* label,
                                    std::span<const Choice> choices, std::size_t current,
                                    float width);

}  // namespace evenlift::view
