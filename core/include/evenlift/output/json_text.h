// Writes JSON in this project's layout. The caller writes inner values first and passes them to the
// functions that write outer ones.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::json {

// A name, and a value that is already JSON.
using Member = std::pair<std::string_view, std::string>;

std::string number(double value);         // the fewest digits that read back to the same double
std::string text(std::string_view utf8);  // quoted and escaped
std::string boolean(bool value);
std::string pair(const Vec2& point);  // [x, y]

std::string array(const std::vector<std::string>& items);  // on one line
std::string array(std::initializer_list<std::string> items);
std::string numbers(const std::vector<double>& values);
std::string wholes(const std::vector<std::size_t>& values);
std::string texts(const std::vector<std::string>& values);
std::string object(const std::vector<Member>& members);  // on one line
std::string object(std::initializer_list<Member> members);

// Both write one item or member per line, indented by 2 (depth + 1) spaces. A value of several
// lines must have been written with depth + 1. Without items the text is [] or {}.
std::string long_array(const std::vector<std::string>& items, int depth);
std::string long_object(const std::vector<Member>& members, int depth);

// Joins the lines of a JSON text into one. The text may have line breaks only between items; text()
// escapes line breaks within strings. O(bytes).
std::string on_one_line(std::string_view text);

// Writes an array of points, one [x, y] per line, like long_array().
std::string points(const Points& points, int depth);

}  // namespace evenlift::json
