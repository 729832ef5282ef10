#include "output/trace_words/step_words.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/output/words.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

constexpr int most_decimals_shown = 9;
constexpr double least_fixed = 1e-5;  // below, fixed() would show almost no digits

// About four significant digits, but no decimals of large numbers.
int decimals_shown(double scale) { return scale >= 1e4 ? 0 : decimals_for(scale) + 1; }

std::string rounded(double value, int decimals, double scale) {
  return scale < least_fixed ? significant(value, 4)
                             : fixed(value, std::min(decimals, most_decimals_shown));
}

std::string number_written(double value, double other, double scale) {
  int decimals = decimals_shown(scale);
  const bool differs = value != other && !lengths_tie(value, other);
  while (differs && decimals < most_decimals_shown &&
         rounded(value, decimals, scale) == rounded(other, decimals, scale))
    ++decimals;
  return rounded(value, decimals, scale);
}

std::string ratio_written(double ratio, double other) {
  if (std::fabs(ratio - 1) <= tau) return "1";
  int decimals = 3;
  const auto looks_like = [&](double known) {
    return std::fabs(ratio - known) > tau && fixed(ratio, decimals) == fixed(known, decimals);
  };
  while (decimals < most_decimals_shown && (looks_like(1) || looks_like(other))) ++decimals;
  return fixed(ratio, decimals);
}

std::string counted_written(const Piece& piece) {
  const std::string one(piece.text), many = one == "vertex" ? "vertices" : one + "s";
  return count_of(static_cast<std::size_t>(piece.a), one.c_str(), many.c_str());
}

}  // namespace

std::string written(const Piece& piece) {
  switch (piece.kind) {
    case Piece::Kind::whole:
      return fixed(piece.a, 0);
    case Piece::Kind::counted:
      return counted_written(piece);
    case Piece::Kind::number:
      return number_written(piece.a, piece.b, piece.c);
    case Piece::Kind::ratio:
      return ratio_written(piece.a, piece.b);
    case Piece::Kind::point:
      return say("({x}, {y})", {number_written(piece.a, piece.a, piece.c),
                                number_written(piece.b, piece.b, piece.c)});
    case Piece::Kind::fixed:
      return fixed(piece.a, static_cast<int>(piece.b));
    case Piece::Kind::amount:
      return amount(piece.a, piece.b);
    case Piece::Kind::load:
      return amount(piece.a, piece.b) + "\u00A0" + std::string(piece.text);
    case Piece::Kind::exact:
      return plain(piece.a);
    case Piece::Kind::percent:
      return percentage(piece.a);
    case Piece::Kind::text:
      break;
  }
  return std::string(translated(piece.text));
}

std::string fill(std::string_view pattern, std::initializer_list<Piece> pieces) {
  std::vector<std::string> texts;
  for (const Piece& piece : pieces) texts.push_back(written(piece));
  return say_written(pattern, texts.data(), texts.size());
}

std::string sentences(std::initializer_list<Piece> each) {
  std::string text;
  for (const Piece& piece : each) {
    const std::string sentence = written(piece);
    if (!text.empty() && !sentence.empty()) text += ' ';
    text += sentence;
  }
  return text;
}

Piece whole(std::size_t number) { return {Piece::Kind::whole, static_cast<double>(number)}; }

Piece counted_from_1(std::size_t index) { return whole(index + 1); }

Piece counted(std::size_t number, std::string_view noun) {
  return {Piece::Kind::counted, static_cast<double>(number), 0, 0, noun};
}

Piece number(double value, double scale) { return {Piece::Kind::number, value, value, scale}; }

Piece number_unlike(double value, double other, double scale) {
  return {Piece::Kind::number, value, other, scale};
}

Piece with_decimals(double value, int decimals) {
  return {Piece::Kind::fixed, value, static_cast<double>(decimals)};
}

Shown shown_in(const Units& units) {
  Shown shown;
  shown.units = units;
  return shown;
}

Piece exact(double value) { return {Piece::Kind::exact, value}; }

Piece percent(double share) { return {Piece::Kind::percent, share}; }

Piece ratio_text(double ratio, double other) { return {Piece::Kind::ratio, ratio, other}; }

Piece length_text(const Trace& trace, double value) {
  return number(value, trace.polygon().diagonal());
}

Piece area_text(const Trace& trace, double value) {
  return number(value, 0.1 * trace.polygon().diagonal() * trace.polygon().diagonal());
}

Piece point_text(const Trace& trace, const Vec2& point) {
  return {Piece::Kind::point, point.x, point.y, trace.polygon().diagonal()};
}

Piece load_text(const Trace& trace, double value) {
  return {Piece::Kind::amount, value, trace.placement.loads->max};
}

Piece weight_text(const Trace& trace, double value) {
  return weight_text(trace, value, trace.placement.loads->max);
}

Piece weight_text(const Trace& trace, double value, double largest) {
  return {Piece::Kind::load, value, largest, 0, name(trace.units.weight)};
}

Piece margin_text(double value) { return with_decimals(value, margin_decimals(value)); }

std::string cargo_text(const Trace& trace, std::uint32_t item) {
  // The name is the user's and is not translated.
  const std::string number_and_name[] = {written(counted_from_1(item)),
                                         trace.placement.settings.cargo[item].name};
  return number_and_name[1].empty() ? say_written("Cargo {item}", number_and_name, 1)
                                    : say_written("Cargo {item}, “{name}”,", number_and_name, 2);
}

MetricWords words_of(Metric metric) {
  switch (metric) {
    case Metric::circle:
      return {
          "The score is the area of the circles inscribed in the triangles between H and its ends.",
          "The one that adds the largest inscribed circles.",
          "of those left, it adds the largest inscribed circles",
          "Team {team} takes the chord whose ends leave room for the largest circles beyond the lifting base: the wider the lifting base, the harder it is to tip the object.",
          "The circles have an area of {area}; those of the next best chord have {next}."};
    case Metric::distance:
      return {
          "The score is the amount by which it reduces the leverage of weight on the vertices.",
          "The one that reduces the leverage of weight on the vertices most.",
          "of those left, it reduces the leverage of weight on the vertices most",
          "Team {team} takes the chord that most reduces the leverage of weight on the vertices: the wider the lifting base, the harder it is to tip the object.",
          "It reduces this leverage by {lever}, the next best chord by {next}."};
    case Metric::area:
      break;
  }
  return {
      "The score is the area, within the object, of the triangles between H and its two ends.",
      "The one that adds the most area.", "of those left, it adds the most area",
      "Team {team} takes the chord that adds the most area to the lifting base: the wider the lifting base, the harder it is to tip the object.",
      "It adds an area of {area}; the next best chord would add {next}."};
}

Piece score_text(const Trace& trace, Rule rule, double value, double other) {
  if (rule == Rule::most_even) return ratio_text(value, other);
  const double size = trace.polygon().diagonal();
  const bool is_length =
      rule == Rule::longest_even || rule == Rule::longest || scores_are_lengths(trace.metric());
  return number_unlike(value, other, is_length ? size : 0.1 * size * size);
}

std::string score_or_bound(const Piece& score, bool exact) {
  return exact ? written(score) : fill("at most {score}", {score});
}

double slope_degrees(const Vec2& direction) {
  if (is_vertical(direction)) return 90;
  const Vec2 u = direction.x < 0 ? Vec2(-direction) : direction;
  return 180 / pi * arctangent2(u.y, u.x);
}

}  // namespace evenlift
