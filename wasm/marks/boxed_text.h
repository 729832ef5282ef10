// A text in a box, over the picture.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "picture/painter.h"

namespace evenlift::view {

// Draws the text beside a spot, and moves it if necessary to keep it inside the window.
void draw_word(ImDrawList& list, const Vec2& spot, const Rect& window, const Theme& theme,
               Colour colour, const std::string& text);

// Fractions of a line's length, the best first.
using SharesOfLine = std::array<double, 6>;
inline constexpr SharesOfLine from_middle = {0.5, 0.32, 0.68, 0.18, 0.82, 0.9};

// The box of a text on a line, at the first fraction where the box covers none of `before`; nullopt
// if no fraction works. Adds the box to `before`. All values are in pixels.
std::optional<Rect> clear_box_on_line(const Vec2& from, const Vec2& to, const Vec2& size,
                                      const SharesOfLine& shares, std::vector<Rect>& before);

// The box of a text that must appear: if no fraction works, the box is at the first one. Adds the
// box to `before`.
Rect box_on_line(const Vec2& from, const Vec2& to, const Vec2& size, const SharesOfLine& shares,
                 std::vector<Rect>& before);

// The text with a capital at its beginning, if it begins with a letter from a to z.
std::string capitalised(std::string text);

}  // namespace evenlift::view
