// The pieces of the walkthrough's sentences. A piece is a few numbers until one function writes it;
// making strings at each place took a third of the walkthrough's code.
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
    load,
    exact,
    percent
  };
  // A piece does not own its text: it must not outlive the call for which it is made.
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

// The pattern in the reader's language with the pieces in the places of its {names}, as by say().
std::string fill(std::string_view pattern, std::initializer_list<Piece> pieces);

// Sentences in the reader's language, joined by spaces. Empty ones are left out.
std::string sentences(std::initializer_list<Piece> each);

// A whole number. counted_from_1(0) is "1", and counted(3, "team") is "3 teams".
Piece whole(std::size_t number);
Piece counted_from_1(std::size_t index);
Piece counted(std::size_t number, std::string_view noun);

// A number with about four significant digits of `scale`. number_unlike() adds decimals, up to
// nine, if the number would look like `other` but does not tie with it.
Piece number(double value, double scale);
Piece number_unlike(double value, double other, double scale);

// A number with a fixed number of decimals.
Piece with_decimals(double value, int decimals);

// A number with the fewest digits that read back to the same.
Piece exact(double value);

// A share of 1 as a percentage.
Piece percent(double share);

// A load ratio with three decimals, or with more if it would look like 1 or `other` but is neither.
Piece ratio_text(double ratio, double other = 1);

// Lengths and areas of a trace's object.
Piece length_text(const Trace& trace, double value);
Piece area_text(const Trace& trace, double value);
Piece point_text(const Trace& trace, const Vec2& point);

// A load as in loads_in_words, without and with its unit, in a trace with teams; and a margin.
Piece load_text(const Trace& trace, double value);
Piece weight_text(const Trace& trace, double value);
Piece weight_text(const Trace& trace, double value, double largest);
Piece margin_text(double value);

// An item of cargo, with its name if it has one: "Cargo 2, “motor”,".
std::string cargo_text(const Trace& trace, std::uint32_t item);

// The walkthrough's words for a metric: the quantity that it measures, the merit of the candidate
// that wins, asked for and told, the place of the winning chord, and its lead over the next best.
struct MetricWords {
  const char *score, *asked, *wins, *chord, *gains;
};
MetricWords words_of(Metric metric);

// The value of a score in the unit of the trace's metric and rule, with enough decimals to
// distinguish it from `other`.
Piece score_text(const Trace& trace, Rule rule, double value, double other);

// The score, or "at most" it if it is an upper bound.
std::string score_or_bound(const Piece& score, bool exact);

// The angle between a direction and the x axis, in degrees, in (-90, 90]; 90 within tolerance of
// vertical.
double slope_degrees(const Vec2& direction);

}  // namespace evenlift
