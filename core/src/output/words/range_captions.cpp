// What the steps of ranges and of exchanges of teams say.
#include <algorithm>

#include "evenlift/output/words.h"
#include "output/words/listed.h"
#include "output/words/step_captions.h"
#include "output/words/swap_answers.h"

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
          ? "A team need not stand at the best place of edges # and #: anywhere between these two chords robots of this size can stand with a load ratio of at least #. "
          : "A team need not stand at the best place of edges # and #: anywhere between these two chords its load ratio is at least #. ",
      {a, b, least()});
  if (last == no_index)
    return where +
           fill(
               "A sixteenth from one end it offers candidate #; from the other end the team's two robots would collide there.",
               {counted_from_1(first)});
  return where + fill("A sixteenth from either end the range offers candidates # and #.",
                      {counted_from_1(first), counted_from_1(last)});
}

std::string StepCaptions::moves_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  switch (swap.kind) {
    case ExchangeKind::single:
      return fill("Team # leaves candidate # for candidate #. ",
                  {counted_from_1(swap.teams[0]), counted_from_1(swap.from[0]),
                   counted_from_1(swap.to[0])});
    case ExchangeKind::pair:
      return fill("Of all pairs of candidates the best one is taken: # to #. ",
                  {swap.teams.size() == 1 ? fill("team # goes", {counted_from_1(swap.teams[0])})
                                          : std::string("both teams go"),
                   swap.to.size() == 1 ? fill("candidate #", {counted_from_1(swap.to[0])})
                                       : "candidates " + numbers_from_1(swap.to)});
    case ExchangeKind::one_more:
      break;
  }
  return fill(
      "One team fewer, exchanged likewise, does better even with any further team: # to #. ",
      {swap.teams.size() == 1 ? fill("team # goes", {counted_from_1(swap.teams[0])})
                              : "teams " + numbers_from_1(swap.teams) + " go",
       (swap.to.size() == 1 ? "candidate " : "candidates ") + numbers_from_1(swap.to)});
}

std::string StepCaptions::gain_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  const auto coverage = told_apart(swap.before.coverage, swap.after.coverage);
  switch (swap.decided_by) {
    case HoldKey::level:
      return swap.before.level == 0
                 ? fill(
                       "Now the robots' contact holds the object, with a margin of #; it covers #, instead of #.",
                       {margin_in_text(swap.margin), coverage[1], coverage[0]})
                 : fill("The hold gets firmer: its margin goes from # to #.",
                        {margin_in_text(swap.margin_before), margin_in_text(swap.margin)});
    case HoldKey::coverage:
      return fill(
          swap.after.level == 0
              ? "The lifting base covers # of the object, instead of #; it holds no better."
              : "The lifting base covers # of the object, instead of #, and the hold is as firm.",
          {coverage[1], coverage[0]});
    case HoldKey::ratios:
      break;
  }
  return "The hold is as firm, the coverage the same, and the teams share their loads more evenly.";
}

std::string StepCaptions::swap() const { return moves_of_swap() + gain_of_swap(); }

std::string StepCaptions::held() const {
  const ExchangeHistory& history = *trace_.exchanges;
  const std::string end =
      history.exchanges.empty()
          ? "No exchange of a team for another candidate is better."
          : fill("After # no other is better.", {counted(history.exchanges.size(), "exchange")});
  const std::string settled = history.settled ? end : "The search for better teams ends here.";
  return settled +
         (placement_.closure.form_closure
              ? " The robots hold the object. One team more would never lose that, though all teams might be others."
              : " The robots do not bring it into form closure: no choice that was tried does.");
}

}  // namespace evenlift
