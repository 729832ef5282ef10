// Writes JSON as this project lays it out. Pieces of text are put together from the inside out.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::json {

// A name, and a value that is JSON already.
using Member = std::pair<std::string_view, std::string>;

std::string number(double value);         // the fewest digits that read back to the same double
std::string text(std::string_view utf8);  // quoted and escaped
std::string boolean(bool value);
std::string pair(const Vec2& point);  // [x, y]

std::string array(const std::vector<std::string>& items);  // on one line
std::string array(std::initializer_list<std::string> items);
std::string numbers(const std::vector<double>& values);  // an array of them
std::string object(const std::vector<Member>& members);  // on one line
std::string object(std::initializer_list<Member> members);

// One item or member to a line, which are indented by two spaces more than `depth` times two; the
// values that span lines themselves were made for depth + 1. Nothing inside is [] or {}.
std::string long_array(const std::vector<std::string>& items, int depth);
std::string long_object(const std::vector<Member>& members, int depth);

// Points, one to a line.
std::string points(const Points& points, int depth);

}  // namespace evenlift::json
