// The formulas of the steps.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "evenlift/trace.h"
#include "output/trace_words/pseudo_code.h"
#include "output/trace_words/trace_text.h"
#include "trace/step_rows.h"

namespace evenlift {

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
