// Writes the walkthrough's sentences. A piece of a sentence holds a few numbers until one function,
// written(), turns them into text. Building strings at each place took a third of the walkthrough's
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
    load,
    exact,
    percent
  };
  // A piece does not own its text and must not outlive it.
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

// Puts the pieces in place of the {names} of the translated pattern, as say() does.
std::string fill(std::string_view pattern, std::initializer_list<Piece> pieces);

// Translates the pieces and joins them by spaces. Leaves out empty pieces.
std::string sentences(std::initializer_list<Piece> each);

// counted_from_1(0) is "1", and counted(3, "team") is "3 teams".
Piece whole(std::size_t number);
Piece counted_from_1(std::size_t index);
Piece counted(std::size_t number, std::string_view noun);

// A number with the decimals that give `scale` about four significant digits. number_unlike() adds
// decimals, up to nine, if the number would look like `other` but does not tie with it.
Piece number(double value, double scale);
Piece number_unlike(double value, double other, double scale);

Piece with_decimals(double value, int decimals);

// How words about a placement are written for a trace in these units.
Shown shown_in(const Units& units);

// A number with the fewest digits that read back to the same number.
Piece exact(double value);

// A share from 0 to 1, as a percentage.
Piece percent(double share);

// A ratio with three decimals, or with more if it would look like 1 or `other` but is neither.
Piece ratio_text(double ratio, double other = 1);

// A length, an area and a point, with decimals that suit the size of the trace's object.
Piece length_text(const Trace& trace, double value);
Piece area_text(const Trace& trace, double value);
Piece point_text(const Trace& trace, const Vec2& point);

// Loads as in loads_in_words(): load_text() writes no unit, weight_text() does. The decimals suit
// `largest` or, without it, the greatest load; the trace's placement must then have loads.
Piece load_text(const Trace& trace, double value);
Piece weight_text(const Trace& trace, double value);
Piece weight_text(const Trace& trace, double value, double largest);
Piece margin_text(double value);

// Names the item by its number, and by its name if it has one: "Cargo 2, “motor”,".
std::string cargo_text(const Trace& trace, std::uint32_t item);

// Sentences about a metric. `score` says what the score measures. `asked` follows the question
// which candidate wins, and names the winner's merit. `wins`, a clause, says that it has this
// merit. `chord` says which chord a team takes, and `gains` compares it with the next best.
struct MetricWords {
  const char *score, *asked, *wins, *chord, *gains;
};
MetricWords words_of(Metric metric);

// A score by this rule and the trace's metric: a ratio, a length or an area. It has enough decimals
// to differ from `other`, as in number_unlike() or ratio_text().
Piece score_text(const Trace& trace, Rule rule, double value, double other);

// Writes the score, with "at most" before it if it is only an upper bound.
std::string score_or_bound(const Piece& score, bool exact);

// The angle to the x axis in degrees, in (-90, 90]. It is 90 if the direction is vertical within
// tolerance.
double slope_degrees(const Vec2& direction);

}  // namespace evenlift
