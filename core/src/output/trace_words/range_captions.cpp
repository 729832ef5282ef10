// Captions of the steps for ranges and for swaps of teams.
#include <algorithm>

#include "evenlift/output/words.h"
#include "output/trace_words/step_captions.h"
#include "output/trace_words/swap_answers.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

std::string margin_in_text(const std::optional<double>& margin) {
  return margin ? written(margin_text(*margin)) : std::string("none");
}

}  // namespace

std::string StepCaptions::range() const {
  const RangeDetail& range = *detail_.range;
  const Piece a = counted_from_1(range.pair.a), b = counted_from_1(range.pair.b);
  const auto [first, last] = range.candidates;
  const std::string where = fill(
      placement_.stands
          ? "A team need not stand at the best place on edges # and #: anywhere between these two chords, robots of this size can stand with a load ratio of at least #. "
          : "A team need not stand at the best place on edges # and #: anywhere between these two chords, its load ratio is at least #. ",
      {a, b, least()});
  if (last == no_index)
    return where +
           fill(
               "A sixteenth from one end, the range offers candidate #; at the other end, the team's two robots would collide.",
               {counted_from_1(first)});
  return where + fill("A sixteenth from either end, the range offers candidates # and #.",
                      {counted_from_1(first), counted_from_1(last)});
}

std::string StepCaptions::moves_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  switch (swap.kind) {
    case SwapKind::single:
      return fill("Team # swaps candidate # for candidate #. ",
                  {counted_from_1(swap.teams[0]), counted_from_1(swap.from[0]),
                   counted_from_1(swap.to[0])});
    case SwapKind::pair:
      return fill("Of all pairs of candidates, the best is taken: # to #. ",
                  {swap.teams.size() == 1 ? fill("team # moves", {counted_from_1(swap.teams[0])})
                                          : std::string("both teams move"),
                   swap.to.size() == 1 ? fill("candidate #", {counted_from_1(swap.to[0])})
                                       : "candidates " + numbers_from_1(swap.to)});
    case SwapKind::one_more:
      break;
  }
  return fill("The result for one team fewer, with one more team added, is better: # to #. ",
              {swap.teams.size() == 1 ? fill("team # moves", {counted_from_1(swap.teams[0])})
                                      : "teams " + numbers_from_1(swap.teams) + " move",
               (swap.to.size() == 1 ? "candidate " : "candidates ") + numbers_from_1(swap.to)});
}

std::string StepCaptions::gain_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  const auto coverage = told_apart(swap.before.coverage, swap.after.coverage);
  switch (swap.decided_by) {
    case HoldKey::level:
      return swap.before.level == 0
                 ? fill(
                       "Now the robots' contact holds the object, with a margin of #; the coverage goes from # to #.",
                       {margin_in_text(swap.margin), coverage[0], coverage[1]})
                 : fill("The margin rises from # to #.",
                        {margin_in_text(swap.margin_before), margin_in_text(swap.margin)});
    case HoldKey::coverage:
      return fill(swap.after.level == 0
                      ? "The coverage rises from # to #; the hold is no better."
                      : "The coverage rises from # to #, and the hold is as strong.",
                  {coverage[0], coverage[1]});
    case HoldKey::ratios:
      break;
  }
  return "The hold and the coverage stay the same, and the teams share their loads more evenly.";
}

std::string StepCaptions::swap() const { return moves_of_swap() + gain_of_swap(); }

std::string StepCaptions::held() const {
  const SwapHistory& history = *trace_.swaps;
  const std::string end =
      history.swaps.empty()
          ? "No swap of a team for another candidate is better."
          : fill("After #, no other swap is better.", {counted(history.swaps.size(), "swap")});
  const std::string settled = history.settled ? end : "The search for better teams ends here.";
  return settled +
         (placement_.closure.form_closure
              ? " The robots hold the object. With one team more they would still hold it, though all teams might differ."
              : " The robots do not bring it into form closure, and no choice that was tried does.");
}

}  // namespace evenlift
