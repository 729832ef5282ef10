#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/icons.h"
#include "ui/ui.h"

namespace evenlift::view {

// For a popup opened with ImGui::OpenPopup(id): below `anchor_low` .. `anchor_high`, or above if
// there is more room. Returns true while open; then add rows and call end_choices().
bool begin_choices(const Ui& ui, const char* id, ImVec2 anchor_low, ImVec2 anchor_high,
                   float least_width);
// With a short remark; true when chosen. `name` is for scripts, in English in every language; "" if
// the label is the name.
bool choice(const Ui& ui, const std::string& label, const char* about, bool current,
            Icon icon = Icon::none, bool enabled = true, const std::string& name = {});
void end_choices(const Ui& ui);

// A setting's button, `width` wide, and the list that a press opens. Returns the chosen index.
struct Choice {
  const char* label;
  const char* about = nullptr;
};
std::optional<std::size_t> dropdown(const Ui& ui, const char* id, const char* label,
                                    std::span<const Choice> choices, std::size_t current,
                                    float width);

}  // namespace evenlift::view
