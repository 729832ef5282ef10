// Draws texts on cards, and the rules that separate them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ui/ui.h"

namespace evenlift::view {

// Draws a label, with a tip, at the left of its control. Moves Dear ImGui's cursor to the control's
// place, and returns the remaining width.
float labelled(const Ui& ui, const char* label, const char* about);

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

}  // namespace evenlift::view
