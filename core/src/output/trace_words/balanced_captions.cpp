// Captions and formulas of the steps for balanced robots.
#include <algorithm>

#include "evenlift/output/robustness_words.h"
#include "evenlift/output/words.h"
#include "output/trace_words/step_captions.h"
#include "output/trace_words/step_formulas.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

Piece load_of_each(const Trace& trace, std::size_t robots) {
  const double load = trace.placement.weight() / static_cast<double>(robots);
  return weight_text(trace, load, load);
}

// "the coverage goes from 83 % to 89 %", with enough decimals to show a difference.
std::string coverage_change(double before, double after) {
  constexpr int most_decimals = 6;
  int decimals = 0;
  while (decimals < most_decimals && before != after &&
         percentage(before, decimals) == percentage(after, decimals))
    ++decimals;
  const std::string from = percentage(before, decimals), to = percentage(after, decimals);
  return from == to ? fill("the coverage stays at #", {to})
                    : fill("the coverage goes from # to #", {from, to});
}

Piece margin_or_0(const std::optional<double>& margin) { return margin_text(margin.value_or(0)); }

// The criteria for the best set, by the goal.
std::string aim_of_sets(const Settings& settings) {
  return goal_of(settings) == Goal::hold
             ? "room between the robots first, then a strong hold, then coverage"
             : "room between the robots first, then coverage";
}

}  // namespace

// --- From the lever to the centroid --------------------------------------------------------------

std::string StepCaptions::lever() const {
  return fill(
      "Two robots with C midway between them have equal arms. By the law of the lever, both carry the same load, #. But what about three?",
      {load_of_each(trace_, 2)});
}

std::string StepFormulas::lever() const {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const double arm = length(robots[1].position - trace_.centre),
               whole_length = length(robots[1].position - robots[0].position);
  return fill("W1 = W × |C r2| / |r1 r2| = # × # / # = #",
              {exact(placement_.weight()), length_text(trace_, arm),
               length_text(trace_, whole_length), load_of_each(trace_, 2)});
}

std::string StepCaptions::three() const {
  return "Three robots. Robots 1 and 2 together lift as if they were at the middle M between them. The lever from robot 3 to M has arms in the ratio 2 to 1, so robot 3 carries one third, and the other two carry one third each. The same is true from every corner: C is the centroid of the three.";
}

std::string StepFormulas::three() const {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const Vec2 middle = (robots[0].position + robots[1].position) / 2;
  const double arm = length(middle - trace_.centre);
  return fill("W3 = W × |C M| / |r3 M| = # × # / # = #",
              {exact(placement_.weight()), length_text(trace_, arm),
               length_text(trace_, length(robots[2].position - middle)), load_of_each(trace_, 3)});
}

std::string StepCaptions::many() const {
  const std::size_t robots = detail_.balanced->robots.size();
  return fill(
      "The law of the centroid: # can carry equal loads if C is the centroid of their places. They do if forces are controlled, or if all are equally stiff and level and the object does not bend. Lay the arrows from C to the robots end to end, each scaled to its share of the weight: they return to C, so no side pulls harder than another.",
      {counted(robots, "robot")});
}

std::string StepFormulas::many() const {
  const std::size_t robots = detail_.balanced->robots.size();
  return fill("(p1 + … + p#) / # = # = C, W / # = #",
              {whole(robots), whole(robots), point_text(trace_, trace_.centre), whole(robots),
               load_of_each(trace_, robots)});
}

// --- A first set ---------------------------------------------------------------------------------

std::string StepCaptions::rest() const {
  const BalancedDetail& balanced = *detail_.balanced;
  const std::size_t placed = balanced.rest.size();
  if (placed == 0)
    return "How are such places found? The middle between two robots must be C itself.";
  return fill(
      "How are such places found? Let # stand here, and add two so that C is the centroid of all #. Then the middle between those two can be only one point: M, at #.",
      {placed == 1 ? Piece("one robot") : counted(placed, "robot"), whole(placed + 2),
       point_text(trace_, balanced.middle)});
}

std::string StepFormulas::rest() const {
  const BalancedDetail& balanced = *detail_.balanced;
  if (balanced.rest.empty()) return {};
  return fill(balanced.rest.size() == 1 ? "M = (# C − p1) / 2 = #"
                                        : "M = (# C − the sum of the places taken) / 2 = #",
              {whole(balanced.rest.size() + 2), point_text(trace_, balanced.middle)});
}

std::string StepCaptions::mirror() const {
  const std::size_t chords = detail_.balanced->chords.size();
  return fill(
      "Which two points of the boundary have M midway between them? Turn the outline about M by half a turn. Each point where it meets its copy is on the boundary, and so is the point straight across M: # #.",
      {counted(chords, "chord"), chords == 1 ? "has M in its middle" : "have M in their middle"});
}

std::string StepCaptions::completion() const {
  const BalancedDetail& balanced = *detail_.balanced;
  const std::size_t chords = balanced.chords.size();
  const Piece robots = whole(balanced.robots.size());
  std::string text =
      chords == 1
          ? fill("This chord makes a set of # robots that can carry equal loads.", {robots})
          : fill(
                "Each of the # chords makes a set of # robots that can carry equal loads. The best is chord #.",
                {whole(chords), robots, counted_from_1(balanced.chosen)});
  if (!balanced.rest.empty())
    text += fill(
        " The first robot was tried at # points along the outline, and this set is the best of all (#). Its coverage is #.",
        {whole(trace_.history.stands), aim_of_sets(placement_.settings),
         percent(balanced.keys.coverage)});
  return text;
}

std::string StepCaptions::start() const {
  const BalancedSet& set = trace_.history.start[item_];
  const std::size_t robots = set.robots.size(), kept = set.kept.size();
  const Piece covers = percent(detail_.balanced->keys.coverage);
  if (set.at_once)
    return fill(
        "# robots, found together on the parts of the boundary that robots of this size can use, with C as their centroid. Their coverage is #.",
        {whole(robots), covers});
  if (robots == 2) return "Two robots, at the ends of a chord with C in its middle.";
  if (set.came.size() == 2)
    return fill(
        "# robots: the set of # stays, and two more take the ends of a chord with C in its middle, so that C stays the centroid. Their coverage is #.",
        {whole(robots), whole(kept), covers});
  const std::string stays = kept == 0   ? std::string()
                            : kept == 1 ? std::string("one stays, ")
                                        : fill("the set of # stays, ", {whole(kept)});
  return fill(
      "# robots: #one takes a trial point, and two take the ends of a chord with M in its middle. Their coverage is #.",
      {whole(robots), stays, covers});
}

// --- Three robots move at a time -----------------------------------------------------------------

std::string StepCaptions::exchange() const {
  const BalancedDetail& balanced = *detail_.balanced;
  const BalancedMove& move = trace_.history.moves[item_];
  const auto fail = [](int steady) { return whole(static_cast<std::size_t>(std::max(0, steady))); };
  const std::string who = fill(balanced.moved.size() == 1 ? "Robot # moves" : "Robots # move",
                               {numbers_from_1(balanced.moved)});
  const std::string begin = fill("Round #. #: ", {counted_from_1(move.round), who});
  const std::string change = coverage_change(balanced.keys_before.coverage, balanced.keys.coverage);
  switch (move.decided_by) {
    case BalancedKey::near_pairs:
      return begin + fill("# of robots too close to each other, instead of #; #.",
                          {counted(balanced.keys.near_pairs, "pair"),
                           whole(balanced.keys_before.near_pairs), change});
    case BalancedKey::steady:
      return begin + fill("the object stays steady if # fail, instead of #; #.",
                          {fail(balanced.keys.steady), fail(balanced.keys_before.steady), change});
    case BalancedKey::level:
      return begin +
             fill("the margin rises from # to #; #.",
                  {margin_or_0(balanced.margin_before), margin_or_0(balanced.margin), change});
    case BalancedKey::coverage:
      return begin + change + ". C is still the centroid of all.";
    case BalancedKey::spread:
      return begin + change + ", and they stand farther from C.";
    case BalancedKey::places:
      break;
  }
  return begin + "all else stays the same, and they stand earlier along the outline.";
}

std::string StepFormulas::exchange() const {
  const BalancedDetail& balanced = *detail_.balanced;
  return fill("M = (# C − the sum of # places) / 2 = #, the middle of #",
              {whole(balanced.robots.size()), whole(balanced.rest.size()),
               point_text(trace_, balanced.middle), counted(balanced.chords.size(), "chord")});
}

std::string StepCaptions::round() const {
  const auto& moves = trace_.history.moves;
  const auto made = static_cast<std::size_t>(std::count_if(
      moves.begin(), moves.end(), [&](const BalancedMove& move) { return move.round == item_; }));
  return fill(
      "Round # is over: of the # ways to move three robots, # made the set better. Its coverage is now #. Another round begins.",
      {counted_from_1(item_), whole(trace_.history.triples), whole(made),
       percent(detail_.balanced->keys.coverage)});
}

std::string StepCaptions::settled() const {
  const BalancedHistory& history = trace_.history;
  const Piece swaps = counted(history.moves.size(), "swap");
  const Piece first = percent(balanced_keys(*trace_.problem, history.start.back().robots).coverage);
  const Piece last = percent(detail_.balanced->keys.coverage);
  if (!history.settled)
    return fill("After # rounds the search ends. # took the coverage from # to #.",
                {whole(history.rounds), swaps, first, last});
  if (history.moves.empty())
    return fill(
        "No move of three robots makes the set better: the first set is the answer, with a coverage of #.",
        {last});
  return fill(
      "No move of three robots makes the set better: # changed nothing. # took the coverage from # to #.",
      {fill("round #", {whole(history.rounds)}), swaps, first, last});
}

// --- If a robot fails ----------------------------------------------------------------------------

std::string StepCaptions::failure() const {
  const std::optional<RestOfRobots>& rest = detail_.balanced->rest_of[item_];
  const std::string fails =
      failure_in_words(item_, detail_.balanced->rest_of.size(), rest, std::nullopt, trace_.units);
  if (!rest) return fails + " C is outside their lifting base: the object tips over.";
  return fails +
         fill(
             " C is still within their lifting base, which covers # of the object. They # keep it from sliding and turning.",
             {percent(rest->coverage), rest->form_closure                ? "still"
                                       : placement_.closure.form_closure ? "no longer"
                                                                         : "do not"});
}

std::string StepCaptions::failures() const {
  const Robustness known = robustness(placement_);
  const std::string text = failures_in_words(detail_.balanced->rest_of, trace_.units);
  if (known.failures_carried < 2) return text;
  return text +
         fill(known.failures_steady < known.failures_carried
                  ? " The others carry it even if any # fail at once, though it can then tip."
                  : " The others carry it even if any # fail at once.",
              {whole(static_cast<std::size_t>(known.failures_carried))});
}

std::string StepCaptions::pairs() const {
  const Placement& pairs = *trace_.in_pairs;
  const std::size_t teams = pairs.teams.size();
  const double most = pairs.loads->max;
  const std::string loads = load_in_words(pairs.loads->min, most, most, trace_.units);
  const int steady = robustness(pairs).failures_steady;
  return fill(
      "The same number of robots in teams by area have a coverage of # instead of # and carry # each. But every line through C has one robot of each team on either side, so # still carry the object after any # at once, wherever they stand; #. Balanced robots give no such guarantee: each set must be checked.",
      {percent(pairs.coverage), percent(placement_.coverage), loads, counted(teams, "team"),
       counted(teams - 1, "failure"),
       steady < 1 ? std::string("but a single failure can leave it on a knife's edge")
                  : fill("here it stays steady after any #",
                         {counted(static_cast<std::size_t>(steady), "failure")})});
}

}  // namespace evenlift
