// Pieces of SVG: numbers in pixels, elements, text. Attributes have the form ` name="value"`, with
// a leading blank, so that they can be concatenated.
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
std::string path(const std::vector<Points>& rings);   // of closed rings

// An arrow, on a white border that separates it from the shapes below.
std::string arrow(const Vec2& tail, const Vec2& head, std::string_view colour);

// Text with its baseline at `at`.
std::string text(const Vec2& at, double size, std::string_view words,
                 std::string_view attributes = "");

// A generous estimate, since the reader's font is unknown.
// `average` is the width of a character in units of the size.
double text_width(std::string_view words, double size, double average = 0.56);

// The words broken at blanks into lines of at most `width`. A longer word has a line of its own.
std::vector<std::string> wrapped(std::string_view words, double size, double width);

}  // namespace evenlift::svg
