// The words of the walkthrough: sentences, captions, pseudo-code and formulas.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "evenlift/trace.h"
#include "trace/step_rows.h"

namespace evenlift {

// --- Writes the walkthrough's sentences. A piece of a sentence holds a few numbers until one function,
// written(), turns them into text. Building strings at each place took a third of the walkthrough's
// code.

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

// --- The captions of the steps.

// Each step's row in step_words.cpp selects a caption.
class StepCaptions : LookedAtStep {
 public:
  StepCaptions(const Trace& trace, const StepDetail& detail) : LookedAtStep(trace, detail) {}

  std::string polygon() const;
  std::string centroid() const;
  std::string centre() const;
  std::string radial() const;
  std::string ray() const;
  std::string slopes() const;
  std::string sections() const;
  std::string sections_before_choice() const;
  std::string outcome() const;
  std::string opposite() const;
  std::string duplicates() const;
  std::string candidates() const;
  std::string directions() const;
  std::string scores() const;
  std::string team() const;
  std::string base() const;
  std::string fewer() const;
  std::string share() const;
  std::string loads() const;
  std::string coverage() const;
  std::string contacts() const;
  std::string cut() const;
  std::string slide() const;
  std::string closure() const;
  std::string second_order() const;
  std::string result() const;
  std::string lever() const;
  std::string three() const;
  std::string many() const;
  std::string rest() const;
  std::string mirror() const;
  std::string completion() const;
  std::string start() const;
  std::string exchange() const;
  std::string round() const;
  std::string settled() const;
  std::string failure() const;
  std::string failures() const;
  std::string pairs() const;
  std::string range() const;
  std::string swap() const;
  std::string held() const;
  std::string stands() const;
  std::string support() const;
  std::string equations() const;
  std::string by_lever() const;
  std::string by_areas() const;
  std::string by_springs() const;
  std::string extremes() const;
  std::string cargo() const;

 private:
  Piece load(double value) const;
  Piece ratio(double value) const;
  Piece least() const;
  Vec2 far_end(const Chord& chord, std::uint32_t vertex) const;
  std::string verdict_of(const Placement& placement) const;  // in the units of the trace
  std::string facing() const;
  std::string standing(const PairDetail& pair) const;
  std::string same_chord(std::uint32_t candidate) const;
  std::string sources() const;
  std::string ranking(const TeamScores& scores) const;
  static double neighbour(const TeamScores& scores, std::size_t i);
  std::string first_scores(const TeamScores& scores) const;
  std::string team_without_candidates() const;
  std::string moves_of_swap() const;
  std::string gain_of_swap() const;
  std::string own_centre() const;
  std::string with_all_cargo() const;
  std::string what_c_is() const;
  static std::string left(const char* sense, const FreeRegion& region, bool before);
};

// --- The statements of the pseudo-code. Each step of the walkthrough executes one of them. In the
// list, a comment on its own line names the methods that have the statements below it; a comment
// beside a statement refers to that statement only.

enum class Statement : std::uint8_t {
  centre,
  cargo,
  stands,  // if robots have a size or there are no-go edges
  // area, circle and distance
  each_vertex,
  each_hit,
  sort_chords,
  each_pair,
  sections,
  parallel,
  bisecting,
  nearer_end,
  accept,
  opposite,
  merge,
  order,
  first_team,
  first_base,
  each_team,  // also distributed and random
  scores,
  next_team,
  wider_base,  // all but balanced
  range,
  exchange,  // balanced
  // distributed
  open_directions,
  direction,
  // random
  first_robot,
  second_robot,
  // balanced
  centroid_law,
  each_number,
  middle,
  even_chords,
  best_set,
  swap,  // area, circle and distance
  rounds,
  equal_loads,
  failures,
  // given
  each_support,
  equations,
  springs,
  // all
  loads,  // all but balanced and given
  coverage,
  cut,
  slide,
  form_closure,
  second_order,
};

Statement statement_of_outcome(const Trace& trace, const StepDetail& detail);
Statement statement_of_scores(const Trace& trace, const StepDetail& detail);
Statement statement_of_team(const Trace& trace, const StepDetail& detail);
Statement statement_of_fewer(const Trace& trace, const StepDetail& detail);
Statement statement_of_loads(const Trace& trace, const StepDetail& detail);
Statement statement_of_base(const Trace& trace, const StepDetail& detail);

// --- The formulas of the steps.

// Writes the formula of a step with its numbers. The step's row in step_words.cpp selects the
// function.
class StepFormulas : LookedAtStep {
 public:
  StepFormulas(const Trace& trace, const StepDetail& detail) : LookedAtStep(trace, detail) {}

  std::string none() const { return {}; }
  std::string polygon() const;
  std::string centroid() const;
  std::string ray() const;
  std::string sections() const;
  std::string outcome() const;
  std::string opposite() const;
  std::string duplicates() const;
  std::string directions() const;
  std::string scores() const;
  std::string base() const;
  std::string share() const;
  std::string loads() const;
  std::string coverage() const;
  std::string cut() const;
  std::string closure() const;
  std::string lever() const;
  std::string three() const;
  std::string many() const;
  std::string rest() const;
  std::string exchange() const;
  std::string stands() const;
  std::string equations() const;
  std::string by_lever() const;
  std::string by_areas() const;
  std::string by_springs() const;
  std::string extremes() const;
  std::string cargo() const;

 private:
  Piece load(double value) const;
  static Piece corners(const Points& base);
  std::string ratio(const Chord& chord,
                    const char* pattern = "load ratio = {shorter} / {longer} = {ratio}") const;
  const Chord& chord(std::uint32_t i) const;
  std::string compared_with_minimum(const Chord& chord,
                                    std::optional<std::uint32_t> candidate) const;
  std::string score(const TeamScores& scores) const;
};

// --- Texts that steps and questions about swaps share.

// Writes both shares as percentages, with enough decimals, at most six, to show which is larger.
std::array<std::string, 2> told_apart(double a, double b);

// The question that a learner is asked before a swap.
std::string swap_question(const StepDetail& detail, const Question& question);

// The statement that a step executes. O(1).
Statement statement_of(const Trace& trace, const StepDetail& detail);

}  // namespace evenlift
