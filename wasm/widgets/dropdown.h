// Lists from which the user chooses.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/icons.h"
#include "ui/ui.h"

namespace evenlift::view {

// Begins a popup that was opened with ImGui::OpenPopup(id). The popup is below the rectangle from
// `anchor_low` to `anchor_high`, or above it if there is little room below and more above. Returns
// true while the popup is open; in this case add rows and call end_choices().
bool begin_choices(const Ui& ui, const char* id, ImVec2 anchor_low, ImVec2 anchor_high,
                   float least_width);
// Adds a row with a short remark `about`. Returns true when the user chooses the row. `name` is the
// name for scripts, which is always English; "" if the label is this name.
bool choice(const Ui& ui, const std::string& label, const char* about, bool current,
            Icon icon = Icon::none, bool enabled = true, const std::string& name = {});
void end_choices(const Ui& ui);

// One choice of a dropdown. dropdown() lays out a setting's button, `width` wide, and the list that
// a press opens. Returns the index of the choice that the user makes, or nothing.
struct Choice {
  const char* label;
  const char* about = nullptr;
};
std::optional<std::size_t> dropdown(const Ui& ui, const char* id, const char* label,
                                    std::span<const Choice> choices, std::size_t current,
                                    float width);

}  // namespace evenlift::view
