// Captions for ranges and swaps of teams.
#include <algorithm>

#include "evenlift/output/words.h"
#include "output/trace_words/step_captions.h"
#include "output/trace_words/swap_answers.h"
#include "output/words/listed.h"

namespace evenlift {

std::string StepCaptions::range() const {
  const RangeDetail& range = *detail_.range;
  const Piece a = counted_from_1(range.pair.a), b = counted_from_1(range.pair.b);
  const auto [first, last] = range.candidates;
  return sentences(
      {fill(
           placement_.stands
               ? "A team need not stand at the best place on edges {a} and {b}: anywhere between these two chords, robots of this size can stand with a load ratio of at least {least}."
               : "A team need not stand at the best place on edges {a} and {b}: anywhere between these two chords, its load ratio is at least {least}.",
           {a, b, least()}),
       last == no_index
           ? fill(
                 "A sixteenth from one end, the range offers candidate {candidate}; at the other end, the team's two robots would collide.",
                 {counted_from_1(first)})
           : fill("A sixteenth from either end, the range offers candidates {first} and {second}.",
                  {counted_from_1(first), counted_from_1(last)})});
}

// Each moved team takes one of `to`.
std::string StepCaptions::moves_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  const std::string teams = numbers_from_1(swap.teams), to = numbers_from_1(swap.to);
  if (swap.kind == SwapKind::single)
    return fill("Team {team} swaps candidate {from} for candidate {to}.",
                {teams, counted_from_1(swap.from[0]), to});
  const bool pair = swap.kind == SwapKind::pair;
  const std::string move =
      swap.teams.size() == 1 ? fill("team {team} moves to candidate {candidate}", {teams, to})
      : pair                 ? fill("both teams move to candidates {candidates}", {to})
                             : fill("teams {teams} move to candidates {candidates}", {teams, to});
  return fill(pair ? "Of all pairs of candidates, the best is taken: {move}."
                   : "The result for one team fewer, with one more team added, is better: {move}.",
              {move});
}

std::string StepCaptions::gain_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  const auto coverage = told_apart(swap.before.coverage, swap.after.coverage);
  const Piece margin = margin_text(swap.margin.value_or(0));
  switch (swap.decided_by) {
    case HoldKey::level:
      return swap.before.level == 0
                 ? fill(
                       "Now the robots' contact holds the object, with a margin of {margin}; the coverage goes from {from} to {to}.",
                       {margin, coverage[0], coverage[1]})
                 : fill("The margin rises from {from} to {to}.",
                        {margin_text(swap.margin_before.value_or(0)), margin});
    case HoldKey::coverage:
      return fill(swap.after.level == 0
                      ? "The coverage rises from {from} to {to}; the hold is no better."
                      : "The coverage rises from {from} to {to}, and the hold is as strong.",
                  {coverage[0], coverage[1]});
    case HoldKey::ratios:
      break;
  }
  return "The hold and the coverage stay the same, and the teams share their loads more evenly.";
}

std::string StepCaptions::swap() const { return sentences({moves_of_swap(), gain_of_swap()}); }

std::string StepCaptions::held() const {
  const SwapHistory& history = *trace_.swaps;
  const std::string end = history.swaps.empty()
                              ? "No swap of a team for another candidate is better."
                              : fill("After {swaps}, no other swap is better.",
                                     {counted(history.swaps.size(), "swap")});
  return sentences(
      {history.settled ? end : "The search for better teams ends here.",
       placement_.closure.form_closure
           ? "The robots hold the object. With one team more they would still hold it, though all teams might differ."
           : "The robots do not bring it into form closure, and no choice that was tried does."});
}

}  // namespace evenlift
