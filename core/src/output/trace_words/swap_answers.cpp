#include "output/trace_words/swap_answers.h"

#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/why_not.h"
#include "output/trace_words/trace_text.h"

namespace evenlift {
namespace {

std::string against_the_best(const HoldKeys& other, const HoldKeys& best) {
  if (other.level == 0 && best.level > 0) return "the robots would not hold the object";
  if (other.level < best.level) return "their margin would be smaller";
  const auto coverage = told_apart(other.coverage, best.coverage);
  if (better_by(best, other) == HoldKey::coverage)
    return fill("the coverage would be {coverage} instead of {present}",
                {coverage[0], coverage[1]});
  if (better_by(best, other) == HoldKey::ratios)
    return "hold and coverage would be the same, but the teams would share their loads less evenly";
  return "all would be the same, and the first such swap in order is made";
}

}  // namespace

std::array<std::string, 2> told_apart(double a, double b) {
  constexpr int most_decimals = 6;
  int decimals = 0;
  while (decimals < most_decimals && a != b && percentage(a, decimals) == percentage(b, decimals))
    ++decimals;
  return {percentage(a, decimals), percentage(b, decimals)};
}

std::string swap_question(const StepDetail& detail, const Question& question) {
  const SwapDetail& swap = *detail.swap;
  if (question.kind == QuestionKind::leaving_team)
    return written(
        "One team moves to another candidate. Which team should it be, for the strongest hold, and then the greatest coverage?");
  return fill(
      "Team {team} leaves candidate {candidate}. Which candidate should it take, for the strongest hold, and then the greatest coverage?",
      {counted_from_1(swap.teams[0]), counted_from_1(swap.from[0])});
}

std::string other_swap_text(const Trace& trace, const StepDetail& detail, const Question& question,
                            std::uint32_t choice) {
  const OtherSwap other = compare_swap(trace, detail, question, choice);
  const Piece team = counted_from_1(other.team);
  if (!other.candidate) return fill("No other candidate for team {team} is better.", {team});
  const std::string so = against_the_best(other.keys, detail.swap->after);
  return fill(question.kind == QuestionKind::leaving_team
                  ? "The best for team {team} would be candidate {candidate}: then {result}."
                  : "With team {team} at candidate {candidate}, {result}.",
              {team, counted_from_1(*other.candidate), so});
}

}  // namespace evenlift
