// Pieces that the lesson's sentences are put together from. A piece stays a few numbers until it is
// written, by one function for all: strings made at each place would be a third of the lesson's
// code.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "evenlift/trace.h"

namespace evenlift {

struct Piece {
  enum class Kind : std::uint8_t {
    text,
    whole,
    counted,
    number,
    ratio,
    point,
    fixed,
    amount,
    kilograms,
    exact,
    percent
  };
  // Texts are not kept: they live as long as the call that the piece is made for.
  Piece(const char* words) : text(words) {}
  Piece(std::string_view words) : text(words) {}
  Piece(const std::string& words) : text(words) {}
  Piece(Kind which, double first, double second = 0, double third = 0, std::string_view noun = {})
      : kind(which), a(first), b(second), c(third), text(noun) {}

  Kind kind = Kind::text;
  double a = 0, b = 0, c = 0;
  std::string_view text;
};

std::string written(const Piece& piece);

// The pattern with each # replaced by the next piece.
std::string fill(std::string_view pattern, std::initializer_list<Piece> pieces);

// A whole number; its successor, as people count; counted(3, "team") is "3 teams".
Piece whole(std::size_t number);
Piece counted_from_1(std::size_t index);
Piece counted(std::size_t number, std::string_view noun);

// A number among those of size `scale`: about four significant digits of that; with more, up to
// nine decimals, where it would look like `other` but does not tie with it.
Piece number(double value, double scale);
Piece number_unlike(double value, double other, double scale);

// With so many decimals.
Piece with_decimals(double value, int decimals);

// With the fewest digits that read back to the same.
Piece exact(double value);

// A share of 1 as a percentage.
Piece percent(double share);

// A load ratio to three decimals, more where it would look like 1 or like `other` but is not.
Piece ratio_text(double ratio, double other = 1);

// Lengths and areas of a trace's object.
Piece length_text(const Trace& trace, double value);
Piece area_text(const Trace& trace, double value);
Piece point_text(const Trace& trace, const Vec2& point);

// A load, as loads_in_words shows them, without its unit and with it; the trace has teams. A
// margin.
Piece load_text(const Trace& trace, double value);
Piece kilograms_text(const Trace& trace, double value);
Piece margin_text(double value);

// The value of a score, by the trace's metric and rule, told apart from `other`.
Piece score_text(const Trace& trace, Rule rule, double value, double other);

// The angle of a direction with the x axis, in degrees, in (-90, 90], within tolerance of the
// vertical 90.
double slope_degrees(const Vec2& direction);

}  // namespace evenlift
