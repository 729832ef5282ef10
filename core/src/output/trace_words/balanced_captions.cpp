// Captions and formulas for balanced robots.
#include <algorithm>

#include "evenlift/output/robustness_words.h"
#include "evenlift/output/words.h"
#include "output/trace_words/step_words.h"
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
  return from == to ? fill("the coverage stays at {coverage}", {to})
                    : fill("the coverage goes from {from} to {to}", {from, to});
}

Piece margin_or_0(const std::optional<double>& margin) { return margin_text(margin.value_or(0)); }

const char* best_of_sets(const Settings& settings) {
  return goal_of(settings) == Goal::hold
             ? "The first robot was tried at {points} points along the outline, and this set is the best of all (room between the robots first, then a strong hold, then coverage). Its coverage is {coverage}."
             : "The first robot was tried at {points} points along the outline, and this set is the best of all (room between the robots first, then coverage). Its coverage is {coverage}.";
}

}  // namespace

// --- From the lever to the centroid --------------------------------------------------------------

std::string StepCaptions::lever() const {
  return fill(
      "Two robots with C midway between them have equal arms. By the law of the lever, both carry the same load, {load}. But what about three?",
      {load_of_each(trace_, 2)});
}

std::string StepFormulas::lever() const {
  const std::vector<LiftingPoint>& robots = detail_.balanced->robots;
  const double arm = length(robots[1].position - trace_.centre),
               whole_length = length(robots[1].position - robots[0].position);
  return fill("W1 = W × |C r2| / |r1 r2| = {weight} × {arm} / {length} = {load}",
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
  return fill("W3 = W × |C M| / |r3 M| = {weight} × {arm} / {length} = {load}",
              {exact(placement_.weight()), length_text(trace_, arm),
               length_text(trace_, length(robots[2].position - middle)), load_of_each(trace_, 3)});
}

std::string StepCaptions::many() const {
  const std::size_t robots = detail_.balanced->robots.size();
  return fill(
      "The law of the centroid: {robots} can carry equal loads if C is the centroid of their places. They do if forces are controlled, or if all are equally stiff and level and the object does not bend. Lay the arrows from C to the robots end to end, each scaled to its share of the weight: they return to C, so no side pulls harder than another.",
      {counted(robots, "robot")});
}

std::string StepFormulas::many() const {
  const std::size_t robots = detail_.balanced->robots.size();
  return fill("(p1 + … + p{robots}) / {robots} = {point} = C, W / {robots} = {load}",
              {whole(robots), point_text(trace_, trace_.centre), load_of_each(trace_, robots)});
}

// --- A first set ---------------------------------------------------------------------------------

std::string StepCaptions::rest() const {
  const BalancedDetail& balanced = *detail_.balanced;
  const std::size_t placed = balanced.rest.size();
  if (placed == 0)
    return "How are such places found? The middle between two robots must be C itself.";
  return sentences(
      {"How are such places found?",
       placed == 1
           ? fill("Let one robot stand here, and add two so that C is the centroid of all 3.", {})
           : fill("Let {robots} stand here, and add two so that C is the centroid of all {all}.",
                  {counted(placed, "robot"), whole(placed + 2)}),
       fill("Then the middle between those two can be only one point: M, at {point}.",
            {point_text(trace_, balanced.middle)})});
}

std::string StepFormulas::rest() const {
  const BalancedDetail& balanced = *detail_.balanced;
  if (balanced.rest.empty()) return {};
  return fill(balanced.rest.size() == 1
                  ? "M = ({robots} C − p1) / 2 = {point}"
                  : "M = ({robots} C − the sum of the places taken) / 2 = {point}",
              {whole(balanced.rest.size() + 2), point_text(trace_, balanced.middle)});
}

std::string StepCaptions::mirror() const {
  const std::size_t chords = detail_.balanced->chords.size();
  return sentences(
      {"Which two points of the boundary have M midway between them? Turn the outline about M by half a turn.",
       fill(
           chords == 1
               ? "Each point where it meets its copy is on the boundary, and so is the point straight across M: {chords} has M in its middle."
               : "Each point where it meets its copy is on the boundary, and so is the point straight across M: {chords} have M in their middle.",
           {counted(chords, "chord")})});
}

std::string StepCaptions::completion() const {
  const BalancedDetail& balanced = *detail_.balanced;
  const std::size_t chords = balanced.chords.size();
  const Piece robots = whole(balanced.robots.size());
  return sentences(
      {chords == 1
           ? fill("This chord makes a set of {robots} robots that can carry equal loads.", {robots})
           : fill(
                 "Each of the {chords} chords makes a set of {robots} robots that can carry equal loads. The best is chord {best}.",
                 {whole(chords), robots, counted_from_1(balanced.chosen)}),
       balanced.rest.empty()
           ? ""
           : fill(best_of_sets(placement_.settings),
                  {whole(trace_.history.stands), percent(balanced.keys.coverage)})});
}

std::string StepCaptions::start() const {
  const BalancedSet& set = trace_.history.start[item_];
  const std::size_t robots = set.robots.size(), kept = set.kept.size();
  const std::string covers =
      fill("Their coverage is {coverage}.", {percent(detail_.balanced->keys.coverage)});
  if (set.at_once)
    return sentences(
        {fill(
             "{robots} robots, found together on the parts of the boundary that robots of this size can use, with C as their centroid.",
             {whole(robots)}),
         covers});
  if (robots == 2) return "Two robots, at the ends of a chord with C in its middle.";
  if (set.came.size() == 2)
    return sentences(
        {fill(
             "{robots} robots: the set of {kept} stays, and two more take the ends of a chord with C in its middle, so that C stays the centroid.",
             {whole(robots), whole(kept)}),
         covers});
  return sentences(
      {kept > 1
           ? fill(
                 "{robots} robots: the set of {kept} stays, one takes a trial point, and two take the ends of a chord with M in its middle.",
                 {whole(robots), whole(kept)})
           : fill(
                 kept == 1
                     ? "{robots} robots: one stays, one takes a trial point, and two take the ends of a chord with M in its middle."
                     : "{robots} robots: one takes a trial point, and two take the ends of a chord with M in its middle.",
                 {whole(robots)}),
       covers});
}

// --- Three robots move at a time -----------------------------------------------------------------

std::string StepCaptions::exchange() const {
  const BalancedDetail& balanced = *detail_.balanced;
  const BalancedMove& move = trace_.history.moves[item_];
  const auto fail = [](int steady) { return whole(static_cast<std::size_t>(std::max(0, steady))); };
  const Piece round = counted_from_1(move.round);
  const std::string who =
      fill(balanced.moved.size() == 1 ? "Robot {robots} moves" : "Robots {robots} move",
           {numbers_from_1(balanced.moved)});
  const std::string change = coverage_change(balanced.keys_before.coverage, balanced.keys.coverage);
  switch (move.decided_by) {
    case BalancedKey::near_pairs:
      return fill(
          "Round {round}. {robots_move}: {pairs} of robots too close to each other, instead of {before}; {coverage}.",
          {round, who, counted(balanced.keys.near_pairs, "pair"),
           whole(balanced.keys_before.near_pairs), change});
    case BalancedKey::steady:
      return fill(
          "Round {round}. {robots_move}: the object stays steady if {robots} fail, instead of {before}; {coverage}.",
          {round, who, fail(balanced.keys.steady), fail(balanced.keys_before.steady), change});
    case BalancedKey::level:
      return fill(
          "Round {round}. {robots_move}: the margin rises from {from} to {to}; {coverage}.",
          {round, who, margin_or_0(balanced.margin_before), margin_or_0(balanced.margin), change});
    case BalancedKey::coverage:
      return fill("Round {round}. {robots_move}: {coverage}. C is still the centroid of all.",
                  {round, who, change});
    case BalancedKey::spread:
      return fill("Round {round}. {robots_move}: {coverage}, and they stand farther from C.",
                  {round, who, change});
    case BalancedKey::places:
      break;
  }
  return fill(
      "Round {round}. {robots_move}: all else stays the same, and they stand earlier along the outline.",
      {round, who});
}

std::string StepFormulas::exchange() const {
  const BalancedDetail& balanced = *detail_.balanced;
  return fill("M = ({robots} C − the sum of {places} places) / 2 = {point}, the middle of {chords}",
              {whole(balanced.robots.size()), whole(balanced.rest.size()),
               point_text(trace_, balanced.middle), counted(balanced.chords.size(), "chord")});
}

std::string StepCaptions::round() const {
  const auto& moves = trace_.history.moves;
  const auto made = static_cast<std::size_t>(std::count_if(
      moves.begin(), moves.end(), [&](const BalancedMove& move) { return move.round == item_; }));
  return fill(
      "Round {round} is over: of the {ways} ways to move three robots, {made} made the set better. Its coverage is now {coverage}. Another round begins.",
      {counted_from_1(item_), whole(trace_.history.triples), whole(made),
       percent(detail_.balanced->keys.coverage)});
}

std::string StepCaptions::settled() const {
  const BalancedHistory& history = trace_.history;
  const Piece swaps = counted(history.moves.size(), "swap");
  const Piece first = percent(balanced_keys(*trace_.problem, history.start.back().robots).coverage);
  const Piece last = percent(detail_.balanced->keys.coverage);
  if (!history.settled)
    return fill(
        "After {rounds} rounds the search ends. {swaps} took the coverage from {from} to {to}.",
        {whole(history.rounds), swaps, first, last});
  if (history.moves.empty())
    return fill(
        "No move of three robots makes the set better: the first set is the answer, with a coverage of {coverage}.",
        {last});
  return fill(
      "No move of three robots makes the set better: round {round} changed nothing. {swaps} took the coverage from {from} to {to}.",
      {whole(history.rounds), swaps, first, last});
}

// --- If a robot fails ----------------------------------------------------------------------------

std::string StepCaptions::failure() const {
  const std::optional<RestOfRobots>& rest = trace_.report.failures[item_];
  const std::string fails = failure_in_words({placement_, shown_in(trace_.units)}, item_, rest);
  if (!rest) return sentences({fails, "C is outside their lifting base: the object tips over."});
  return sentences(
      {fails,
       fill("C is still within their lifting base, which covers {coverage} of the object.",
            {percent(rest->coverage)}),
       rest->form_closure                ? "They still keep it from sliding and turning."
       : placement_.closure.form_closure ? "They no longer keep it from sliding and turning."
                                         : "They do not keep it from sliding and turning."});
}

std::string StepCaptions::failures() const {
  const Robustness& known = trace_.report.robustness;
  const Shown shown = shown_in(trace_.units);
  std::string text = failures_in_words({{placement_, shown}, trace_.report});
  if (known.failures_carried < 2) return text;
  return sentences(
      {text,
       fill(known.failures_steady < known.failures_carried
                ? "The others carry it even if any {robots} fail at once, though it can then tip."
                : "The others carry it even if any {robots} fail at once.",
            {whole(static_cast<std::size_t>(known.failures_carried))})});
}

std::string StepCaptions::pairs() const {
  const Placement& pairs = *trace_.in_pairs;
  const std::size_t teams = pairs.teams.size();
  const double most = pairs.loads->max;
  const std::string loads = load_in_words(pairs.loads->min, most, most, trace_.units);
  const int steady = trace_.report_of_pairs.robustness.failures_steady;
  const Piece all = counted(teams, "team"), most_failures = counted(teams - 1, "failure");
  return sentences(
      {fill(
           "The same number of robots in teams by area have a coverage of {coverage} instead of {balanced} and carry {loads} each.",
           {percent(pairs.coverage), percent(placement_.coverage), loads}),
       steady < 1
           ? fill(
                 "But every line through C has one robot of each team on either side, so {teams} still carry the object after any {failures} at once, wherever they stand; but a single failure can leave it on a knife's edge.",
                 {all, most_failures})
           : fill(
                 "But every line through C has one robot of each team on either side, so {teams} still carry the object after any {failures} at once, wherever they stand; here it stays steady after any {steady}.",
                 {all, most_failures, counted(static_cast<std::size_t>(steady), "failure")}),
       "Balanced robots give no such guarantee: each set must be checked."});
}

}  // namespace evenlift
