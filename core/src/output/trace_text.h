// Pieces that the lesson's sentences are put together from.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "evenlift/trace.h"

namespace evenlift {

// The pattern with each # replaced by the next value.
std::string fill(std::string_view pattern, std::initializer_list<std::string> values);

// A whole number; counted(3, "team") is "3 teams".
std::string whole(std::size_t number);
std::string counted(std::size_t number, std::string_view noun);

// A number among those of size `scale`: about four significant digits of that.
std::string number(double value, double scale);
// The same with more digits, up to nine decimals, where it would look like `other` but is not.
std::string number_unlike(double value, double other, double scale);

// A load ratio to three decimals, more where it would look like 1 or like `other` but is not.
std::string ratio_text(double ratio, double other = 1);

// The sizes of a trace's lengths and areas: L and its square.
std::string length_text(const Trace& trace, double value);
std::string point_text(const Trace& trace, const Vec2& point);

// A load, as loads_in_words shows them; the trace has teams. A margin.
std::string load_text(const Trace& trace, double value);
std::string margin_text(double value);

// The value of a score, by the trace's metric and rule, told apart from `other`.
std::string score_text(const Trace& trace, Rule rule, double value, double other);

// "ratio 0.951" of a candidate, with its number: "candidate 4".
std::string candidate_text(std::uint32_t candidate);

// The angle of a direction with the x axis, in degrees, in (-90, 90], within tolerance of the
// vertical 90.
std::string angle_text(const Vec2& direction);

}  // namespace evenlift
