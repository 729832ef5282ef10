// Texts on cards, and their separators.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ui/ui.h"

namespace evenlift::view {

// A label left of its control, with a tip. Moves the cursor to the control, and returns the width
// left.
float labelled(const Ui& ui, const char* label, const char* about);

void rule(const Ui& ui);
void tip(const Ui& ui, const char* text);
void text_line(Face face, Colour colour, const std::string& text);
void text_block(Face face, Colour colour, const std::string& text,
                float kept_free = 0);  // width at the right

// The lines, broken at spaces so that none is wider than `width`. O(bytes).
std::vector<std::string_view> broken_lines(Face face, std::string_view text, float width);

// One below the other.
void draw_lines(ImDrawList& list, Face face, ImVec2 at, Colour colour,
                const std::vector<std::string_view>& lines);
float height_of(Face face, const std::vector<std::string_view>& lines);

// A text in constant height: at most `lines` lines, the last one cut off with "…" if there are
// more.
void text_block_of(Face face, Colour colour, const std::string& text, float width,
                   std::size_t lines);

}  // namespace evenlift::view
