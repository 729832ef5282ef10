// Pieces of SVG, with numbers in pixels. Attributes have the form ` name="value"`, with a leading
// blank.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::svg {

std::string px(double value);  // to a hundredth, without trailing zeros

std::string attribute(std::string_view name, std::string_view value);
std::string attribute(std::string_view name, double value);

std::string element(std::string_view tag, std::string_view attributes);  // <tag .../>

std::string path(const Points& points, bool closed);  // the attribute d
std::string path(const std::vector<Points>& rings);   // the attribute d of closed rings

// Draws an arrow with a white border, which separates it from the shapes below.
std::string arrow(const Vec2& tail, const Vec2& head, std::string_view colour);

// Writes words whose baseline is at `at`.
std::string text(const Vec2& at, double size, std::string_view words,
                 std::string_view attributes = "");

// A generous estimate of the text's width, since the reader's font is unknown. `average` is the
// average width of a character in units of the size.
double text_width(std::string_view words, double size, double average = 0.56);

// Breaks words at blanks into lines of at most `width`. A longer word gets a line of its own.
std::vector<std::string> wrapped(std::string_view words, double size, double width);

}  // namespace evenlift::svg
