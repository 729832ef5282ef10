// Texts, and lists from which the user chooses.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/icons.h"
#include "ui/ui.h"

namespace evenlift::view {

// --- Draws texts on cards, and the rules that separate them.

// Draws a label, with a tip, at the left of its control. Moves Dear ImGui's cursor to the control's
// place, and returns the remaining width.
float labelled(const Ui& ui, const char* label, const char* about, float label_width = 120);

void rule(const Ui& ui);  // a line between two parts of a card
void tip(const Ui& ui, const char* text);
void text_line(Face face, Colour colour, const std::string& text);
void text_block(Face face, Colour colour, const std::string& text,
                float kept_free = 0);  // width at the right that stays free

// Returns the text's lines, broken at spaces. Only a line of one word may be wider than `width`.
// O(bytes).
std::vector<std::string_view> broken_lines(Face face, std::string_view text, float width);

void draw_lines(ImDrawList& list, Face face, ImVec2 at, Colour colour,
                const std::vector<std::string_view>& lines);
float height_of(Face face, const std::vector<std::string_view>& lines);

// Draws a text in a block that is always `lines` lines high. If the text has more lines, the last
// one shown ends with "…".
void text_block_of(Face face, Colour colour, const std::string& text, float width,
                   std::size_t lines);

// Returns the text, or its beginning with "…" if it is wider than `width`.
std::string cut_off(Face face, std::string text, float width);

// --- Lists from which the user chooses.

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
