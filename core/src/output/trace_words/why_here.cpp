// Why a team stands there, for readers who do not know the algorithm.
#include <string>

#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "output/trace_words/trace_text.h"

namespace evenlift {
namespace {

// With enough decimals to differ from `other`.
std::string with_unit(const Trace& trace, const TeamScores& scores, double value, double other) {
  const std::string number = written(score_text(trace, scores.rule, value, other));
  const bool length = scores.rule != Rule::score || scores_are_lengths(trace.metric());
  const std::string text = with_length_unit(number, trace.units);
  return length || trace.units.length == LengthUnit::none ? text : text + "²";
}

const char* first_team_is(const TeamScores& scores) {
  if (scores.rule == Rule::most_even)
    return "No chord has two equal halves. The first team takes the chord that comes closest.";
  return scores.rule == Rule::longest
             ? "The first team takes the longest chord that meets the minimum load ratio: the farther apart the robots stand, the wider the lifting base can become."
             : "The first team takes the longest chord with two equal halves: the farther apart the robots stand, the wider the lifting base can become.";
}

// The lead over the next best chord, or the key that decided.
std::string lead(const Trace& trace, const TeamScores& scores) {
  const std::uint32_t winner = scores.ranking[0], second = scores.ranking[1];
  const Candidate &a = trace.placement.candidates[winner], &b = trace.placement.candidates[second];
  const Units& units = trace.units;
  const double size = trace.polygon().diagonal();
  switch (scores.decided_by) {
    case DecidedBy::ratio:
      return fill(
          "Another chord is as good; this one is more even, with a load ratio of {ratio} against {other_ratio}.",
          {ratio_text(a.chord.ratio, b.chord.ratio), ratio_text(b.chord.ratio, a.chord.ratio)});
    case DecidedBy::length:
      return fill("Another chord is as good; this one is longer, {length} against {other_length}.",
                  {with_length_unit(written(number_unlike(a.length, b.length, size)), units),
                   with_length_unit(written(number_unlike(b.length, a.length, size)), units)});
    case DecidedBy::order:
      return "Another chord is as good in every way; this one comes first in order of slope.";
    case DecidedBy::only_one:
    case DecidedBy::first_key:
      break;
  }
  const Score &best = scores.of_candidate[winner], &next = scores.of_candidate[second];
  if (!next.eligible) return "It is the only one.";
  if (scores.rule == Rule::most_even)
    return fill("Its load ratio is {ratio}, that of the next chord {next}.",
                {ratio_text(best.value, next.value), ratio_text(next.value, best.value)});
  if (scores.rule != Rule::score)
    return fill("The next chord is {length} shorter.",
                {with_unit(trace, scores, best.value - next.value, 0)});
  return fill(words_of(trace.metric()).gains,
              {with_unit(trace, scores, best.value, next.value),
               score_or_bound(with_unit(trace, scores, next.value, best.value), next.exact)});
}

}  // namespace

std::string why_here_text(const Trace& trace, const TeamScores& scores) {
  if (scores.decided_by == DecidedBy::only_one) return written("It was the only chord left.");
  const Score& best = scores.of_candidate[scores.ranking.front()];
  return sentences({scores.team == 0 ? first_team_is(scores)
                    : best.value > 0
                        ? fill(words_of(trace.metric()).chord, {counted_from_1(scores.team)})
                        : "No chord left adds anything to the lifting base.",
                    lead(trace, scores)});
}

}  // namespace evenlift
