#include "output/trace_words/step_words.h"

#include <algorithm>

#include "evenlift/angles.h"
#include "evenlift/output/words.h"
#include "evenlift/selection.h"
#include "evenlift/stability.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

// The score of the best candidate is always exact.
const char* best_by(Rule rule) {
  switch (rule) {
    case Rule::longest_even:
    case Rule::longest:
      return "Candidate {candidate} has a length of {length}";
    case Rule::most_even:
      return "Candidate {candidate} has a load ratio of {ratio}";
    case Rule::score:
      break;
  }
  return "Candidate {candidate} has {score}";
}

}  // namespace

Piece StepCaptions::load(double value) const { return weight_text(trace_, value); }

Piece StepCaptions::ratio(double value) const {
  return ratio_text(value, placement_.settings.min_ratio);
}

Piece StepCaptions::least() const { return exact(placement_.settings.min_ratio); }

std::string StepCaptions::radial() const {
  std::string list;
  const std::size_t all = trace_.radial_edges.size(), shown = std::min<std::size_t>(all, 6);
  for (std::size_t i = 0; i < shown; ++i)
    list += (i == 0 ? "" : ", ") + written(counted_from_1(trace_.radial_edges[i]));
  if (shown < all) list += ", …";
  return fill(
      all == 1
          ? "The line of edge {edges} passes through C. Rays from C meet this edge only at its ends, so it faces no other edge."
          : "The lines of edges {edges} pass through C. Rays from C meet these edges only at their ends, so they face no other edge.",
      {list});
}

std::string StepCaptions::ray() const {
  const std::uint32_t vertex = trace_.rays.vertices[item_];
  const std::uint32_t begin = trace_.rays.begins[item_], end = trace_.rays.begins[item_ + 1];
  const std::string from = fill("From vertex {vertex} through C.", {counted_from_1(vertex)});
  if (begin == end)
    return sentences(
        {from, "Beyond C the ray does not meet the boundary: this vertex has no chord."});
  if (end == begin + 1) {
    const VertexChord& chord = trace_.rays.chords[begin];
    const bool known = chord.vertex != vertex;
    const std::uint32_t other = known ? chord.vertex : chord.hit_vertex;
    const bool at_vertex = other != inside_edge;
    return sentences(
        {from,
         fill(
             known
                 ? "Beyond C the ray meets vertex {place}, where this chord was already found: load ratio {ratio}."
             : at_vertex
                 ? "Beyond C the ray meets vertex {place}: a chord with a load ratio of {ratio}."
                 : "Beyond C the ray meets the boundary at {place}: a chord with a load ratio of {ratio}.",
             {at_vertex ? counted_from_1(other) : point_text(trace_, far_end(chord.chord, vertex)),
              ratio(chord.chord.ratio)})});
  }
  constexpr std::uint32_t most = 5;
  std::string ratios;
  for (std::uint32_t i = begin; i < end && i < begin + most; ++i)
    ratios += (i == begin ? "" : ", ") + written(ratio(trace_.rays.chords[i].chord.ratio));
  if (end - begin > most) ratios += ", …";
  return sentences(
      {from,
       fill(
           "Beyond C the ray meets the boundary {hits} times. Each hit makes a chord: load ratios {ratios}.",
           {whole(end - begin), ratios})});
}

Vec2 StepCaptions::far_end(const Chord& chord, std::uint32_t vertex) const {
  return chord.r1.position == trace_.polygon().vertex(vertex) ? chord.r2.position
                                                              : chord.r1.position;
}

std::string StepCaptions::slopes() const {
  const std::vector<std::uint32_t> order = chords_by_slope(trace_);
  if (order.empty()) return "No vertex has a chord: there is nothing to sort.";
  const auto angle = [&](std::uint32_t chord) {
    const Chord& c = trace_.rays.chords[chord].chord;
    return with_decimals(slope_degrees(c.r2.position - c.r1.position), 1);
  };
  return sentences(
      {fill("The {chords} in order of slope, from {first}° to {last}°.",
            {counted(order.size(), "chord"), angle(order.front()), angle(order.back())}),
       "Between two neighbouring chords no edge begins or ends: the same edges face each other."});
}

std::string StepCaptions::facing() const {
  return fill("Edge pair {pair} of {pairs}: edges {a} and {b} face each other across C.",
              {counted_from_1(item_), whole(trace_.pairs.size()),
               counted_from_1(detail_.pair->pair.a), counted_from_1(detail_.pair->pair.b)});
}

std::string StepCaptions::sections_before_choice() const {
  return sentences({facing(), "The facing parts, called sections, end at two chords."});
}

std::string StepCaptions::sections() const {
  return sentences(
      {facing(),
       fill(
           "The facing parts, called sections, end at two chords with load ratios {first} and {second}.",
           {ratio(detail_.pair->ends[0].ratio), ratio(detail_.pair->ends[1].ratio)})});
}

std::string StepCaptions::outcome() const {
  const PairDetail& pair = *detail_.pair;
  const Piece a = counted_from_1(pair.pair.a);
  const Piece b = counted_from_1(pair.pair.b);
  const Piece chosen = ratio(pair.chosen.ratio);
  const std::string off = fill(
      "Reflected through C, edge {b} meets the line of edge {a} outside the sections: none of their chords is even.",
      {b, a});
  std::string text;
  switch (pair.outcome) {
    case Outcome::bisecting:
      text = fill(
          "Reflected through C, edge {b} meets edge {a} within the sections: C bisects the chord there. Equal arms, load ratio 1: a candidate.",
          {b, a});
      break;
    case Outcome::nearer_end:
      text = sentences(
          {off, fill("The more even end has {ratio}, at least the minimum {least}: a candidate.",
                     {chosen, least()})});
      break;
    case Outcome::too_uneven:
      text = sentences(
          {off,
           fill("The more even end has only {ratio}, below the minimum {least}: no candidate here.",
                {chosen, least()})});
      break;
    case Outcome::midpoint:
      text = fill(
          "Edges {a} and {b} are parallel: all their chords have the load ratio {ratio}, at least the minimum {least}. The chord between the middles of the sections is the candidate.",
          {a, b, chosen, least()});
      break;
    case Outcome::parallel_low:
      text = fill(
          "Edges {a} and {b} are parallel: all their chords have the load ratio {ratio}, below the minimum {least}: no candidate here.",
          {a, b, chosen, least()});
      break;
  }
  return sentences({text, pair.standing ? standing(pair) : "",
                    pair.candidate && !pair.stands ? same_chord(*pair.candidate) : ""});
}

// For robots with a size. Empty if the load ratio is already too low.
std::string StepCaptions::standing(const PairDetail& pair) const {
  switch (*pair.standing) {
    case Standing::there:
      return "Robots of this size can stand there.";
    case Standing::elsewhere:
      return fill(
          "Where robots of this size can stand, the best chord has {ratio}, at least the minimum {least}: it is the candidate.",
          {ratio(pair.chosen.ratio), least()});
    case Standing::nowhere:
      break;
  }
  return pair.verdict.candidate
             ? "But robots of this size cannot stand there, nor on another chord that meets the minimum ratio: no candidate."
             : "";
}

// Where a candidate's chord came from.
std::string StepCaptions::same_chord(std::uint32_t candidate) const {
  const std::uint32_t source = trace_.source_of_candidate[candidate];
  if (source == no_index) return {};  // facing edges only where the hands lift
  if (source < trace_.pairs.size())
    return fill("Edge pair {pair} has the same chord.", {counted_from_1(source)});
  const OppositeVertices& two = trace_.opposite[source - trace_.pairs.size()];
  return fill("The opposite vertices {v} and {w} have the same chord, and theirs is kept.",
              {counted_from_1(two.v), counted_from_1(two.w)});
}

std::string StepCaptions::opposite() const {
  const OppositeDetail& opposite = *detail_.opposite;
  const std::string text = fill(
      "Vertices {v} and {w} are opposite each other: the line between them passes through C. Rounding decides whether the edges that meet there also face each other, so the chord between the two vertices is a separate case.",
      {counted_from_1(opposite.vertices.v), counted_from_1(opposite.vertices.w)});
  const Piece own = ratio(opposite.chord.ratio);
  if (!opposite.candidate && placement_.stands &&
      opposite.chord.ratio >= placement_.settings.min_ratio)
    return sentences({text, "Robots of this size cannot stand there: no candidate."});
  if (!opposite.candidate)
    return sentences(
        {text, fill("Its load ratio is only {ratio}, below the minimum {least}: no candidate.",
                    {own, least()})});
  return sentences({text,
                    fill("Its load ratio is {ratio}, at least the minimum {least}: a candidate.",
                         {own, least()}),
                    opposite.stands ? "" : same_chord(*opposite.candidate)});
}

std::string StepCaptions::sources() const {
  if (trace_.opposite.empty()) return written(counted(trace_.pairs.size(), "edge pair"));
  return fill("{edge_pairs} and {pairs} of opposite vertices",
              {counted(trace_.pairs.size(), "edge pair"), counted(trace_.opposite.size(), "pair")});
}

std::string StepCaptions::duplicates() const {
  std::size_t found = 2 * trace_.ranges.size();
  for (const std::uint32_t candidate : trace_.candidate_of_source) found += candidate != no_index;
  const std::size_t kept = placement_.candidates.size();
  if (found == 0) return "No edge pair and no pair of opposite vertices has a candidate.";
  if (found == kept)
    return fill("No chord was found twice: {candidates} from {sources}.",
                {counted(kept, "candidate"), sources()});
  return fill(
      found - kept == 1
          ? "{repeats} of the {found} chords found repeats another, as at a vertex, where two edge pairs meet. Each chord counts once, which leaves {candidates}."
          : "{repeats} of the {found} chords found repeat others, as at a vertex, where two edge pairs meet. Each chord counts once, which leaves {candidates}.",
      {whole(found - kept), whole(found), counted(kept, "candidate")});
}

std::string StepCaptions::candidates() const {
  const std::vector<Candidate>& all = placement_.candidates;
  if (all.empty())
    return fill("There is no candidate: no chord through C has a load ratio of at least {least}.",
                {least()});
  std::size_t even = 0;
  for (const Candidate& candidate : all) even += is_even(candidate.chord);
  const std::string how_even =
      even == 0            ? "None of them is even: equal loads for both robots."
      : even == all.size() ? (even == 1 ? "It is even: equal loads for both robots."
                                        : "All of them are even: equal loads for both robots.")
      : even == 1          ? "One of them is even: equal loads for both robots."
                  : fill("{even} of them are even: equal loads for both robots.", {whole(even)});
  return sentences(
      {fill("{candidates}, in order of slope.", {counted(all.size(), "candidate")}), how_even});
}

std::string StepCaptions::directions() const {
  return fill(
      "Lines through C that meet the boundary on both sides of C span {degrees}° of 180°. The teams divide these directions equally.",
      {with_decimals(180 / pi * open_directions_rad(trace_.polygon(), trace_.centre), 1)});
}

// "Candidate 6 has 571.7, candidate 5 has 520.6, candidate 2 has 394.9."
std::string StepCaptions::ranking(const TeamScores& scores) const {
  constexpr std::size_t most = 3;
  std::string text;
  const std::vector<std::uint32_t>& order = scores.ranking;
  for (std::size_t i = 0; i < order.size() && i < most; ++i) {
    const Score& score = scores.of_candidate[order[i]];
    if (i > 0 && !score.eligible) break;
    text += (i == 0 ? "" : ", ") +
            fill(i == 0        ? best_by(scores.rule)
                 : score.exact ? "candidate {candidate} has {score}"
                               : "candidate {candidate} has at most {score}",
                 {counted_from_1(order[i]),
                  score_text(trace_, scores.rule, score.value, neighbour(scores, i))});
  }
  return order.size() > most ? fill("{ranking}, and so on.", {text}) : text + ".";
}

// The value from which the i-th must look different: the nearest earlier one that differs; for the
// first, the next.
double StepCaptions::neighbour(const TeamScores& scores, std::size_t i) {
  const auto value = [&](std::size_t j) { return scores.of_candidate[scores.ranking[j]].value; };
  for (std::size_t j = i; j-- > 0;)
    if (!lengths_tie(value(j), value(i))) return value(j);
  return i == 0 && scores.ranking.size() > 1 ? value(1) : value(i);
}

std::string StepCaptions::first_scores(const TeamScores& scores) const {
  return sentences(
      {scores.rule == Rule::longest_even
           ? "The first team takes the longest even candidate, for a wide lifting base."
       : scores.rule == Rule::longest
           ? "All candidates meet the minimum ratio, so the first team takes the longest, for a wide lifting base."
           : "No candidate is even, so the first team takes the one with the largest load ratio.",
       ranking(scores)});
}

std::string StepCaptions::scores() const {
  const TeamScores& scores = *detail_.scores;
  if (item_ == 0) return first_scores(scores);
  return sentences(
      {fill("Team {team}: how much would each candidate add?", {counted_from_1(scores.team)}),
       words_of(trace_.metric()).score,
       scores.of_candidate[scores.ranking.front()].value > 0 ? ranking(scores)
                                                             : "No candidate adds anything more."});
}

std::string StepCaptions::team() const {
  if (!detail_.scores) return team_without_candidates();
  const TeamScores& scores = *detail_.scores;
  const std::uint32_t winner = scores.ranking.front();
  const Piece team = counted_from_1(scores.team), own = counted_from_1(winner);
  if (scores.decided_by == DecidedBy::only_one)
    return fill("Team {team} takes candidate {candidate}, the only one left.", {team, own});
  const std::uint32_t second = scores.ranking[1];
  const Piece other = counted_from_1(second);
  const double best = scores.of_candidate[winner].value, next = scores.of_candidate[second].value;
  const Candidate &a = placement_.candidates[winner], &b = placement_.candidates[second];
  switch (scores.decided_by) {
    case DecidedBy::ratio:
      return fill(
          "Team {team} takes candidate {candidate}: it ties with candidate {other} but is more even, {ratio} against {other_ratio}.",
          {team, own, other, ratio_text(a.chord.ratio, b.chord.ratio),
           ratio_text(b.chord.ratio, a.chord.ratio)});
    case DecidedBy::length:
      return fill(
          "Team {team} takes candidate {candidate}: it ties with candidate {other} but is longer, {length} against {other_length}.",
          {team, own, other, number_unlike(a.length, b.length, trace_.polygon().diagonal()),
           number_unlike(b.length, a.length, trace_.polygon().diagonal())});
    case DecidedBy::order:
      return fill(
          "Team {team} takes candidate {candidate}: it ties with candidate {other} in everything but comes first in order of slope.",
          {team, own, other});
    default:
      break;
  }
  if (!scores.of_candidate[second].eligible)
    return fill("Team {team} takes candidate {candidate}, the only even one.", {team, own});
  const Piece exact_lead = scores.rule == Rule::most_even
                               ? ratio_text(best - next, 0)
                               : score_text(trace_, scores.rule, best - next, 0);
  const std::string lead = scores.of_candidate[second].exact
                               ? written(exact_lead)
                               : fill("at least {lead}", {exact_lead});
  return fill(scores.rule == Rule::longest_even || scores.rule == Rule::longest
                  ? "Team {team} takes candidate {candidate}, {lead} longer than candidate {other}."
                  : "Team {team} takes candidate {candidate}, {lead} ahead of candidate {other}.",
              {team, own, lead, other});
}

std::string StepCaptions::team_without_candidates() const {
  const Chord chord = chord_of(placement_.teams[item_]);
  const Piece name = counted_from_1(item_);
  if (placement_.settings.method == Method::random)
    return fill(
        "Team {team}: one robot stands at a random point of the boundary, the other straight across C: {first} and {second}, load ratio {ratio}.",
        {name, point_text(trace_, chord.r1.position), point_text(trace_, chord.r2.position),
         ratio_text(chord.ratio)});
  return fill(
      "Team {team} of {teams} takes the line at {degrees}°, with its robots at the farthest boundary points: load ratio {ratio}.",
      {name, whole(placement_.teams.size()),
       with_decimals(slope_degrees(chord.r2.position - chord.r1.position), 1),
       ratio_text(chord.ratio)});
}

std::string StepCaptions::base() const {
  if (detail_.base == detail_.base_before)
    return "The lifting base H, the convex hull of all robots, does not change.";
  const Piece covers = percent(evenlift::coverage(trace_.object(), detail_.base));
  if (detail_.base_before.empty())
    return "The lifting base H is the convex hull of all robots: so far, the segment between the two.";
  if (detail_.base.size() < 3)
    return "The lifting base H is still a segment: all robots stand on one line.";
  return fill(
      "The lifting base H, the convex hull of all robots, grows to {corners} and covers {coverage} of the object.",
      {counted(detail_.base.size(), "corner"), covers});
}

std::string StepCaptions::verdict_of(const Placement& placement) const {
  const Shown shown = shown_in(trace_.units);
  return verdict({placement, shown});
}

std::string StepCaptions::fewer() const {
  if (placement_.teams.empty()) return verdict_of(placement_);
  return fill(trace_.by_candidates()
                  ? "Only {teams} of the {requested} requested teams: no candidate is left."
                  : "Only {teams} of the {requested} requested teams: no further place was left.",
              {whole(placement_.teams.size()), whole(placement_.requested_teams)});
}

std::string StepCaptions::share() const {
  const Team& team = placement_.teams[item_];
  const Piece item = counted_from_1(item_);
  const Piece all = load(placement_.weight() / static_cast<double>(placement_.teams.size()));
  const double first = team.robots[0].load, second = team.robots[1].load;
  if (is_even(chord_of(team)))
    return fill(
        "Team {team} carries {share}, its share of {weight}. Equal arms, equal loads: {load} for each robot.",
        {item, all, exact(placement_.weight()), load(first)});
  return fill(
      "Team {team} carries {share}, its share of {weight}. By the law of the lever, the robot nearer to C carries more: {greater} and {lesser}.",
      {item, all, exact(placement_.weight()), load(std::max(first, second)),
       load(std::min(first, second))});
}

std::string StepCaptions::loads() const {
  const Shown shown = shown_in(trace_.units);
  const ShownPlacement of(placement_, shown);
  if (trace_.given()) return loads_in_words(of);  // or that the object falls
  // If the model is not the plan's, the text begins with "As planned".
  const std::string planned = loads_in_words({of, Asked{.model = LoadModel::springs}});
  if (trace_.balanced()) return planned;
  const LoadSummary& loads = *placement_.loads;
  return sentences({planned, written(load(loads.min)) == written(load(loads.max))
                                 ? "All carry the same load."
                                 : fill("The arms are unequal, so the spread of loads is {spread}.",
                                        {load(loads.spread)})});
}

std::string StepCaptions::coverage() const {
  if (placement_.lifting_base.size() < 3)
    return "All robots stand on one line, so H has no area: pressing down beside the line tips the object.";
  return fill(
      "H covers {coverage} of the object. Pressing down there does not tip it, as long as robots push back and none is overloaded.",
      {percent(placement_.coverage)});
}

std::string StepCaptions::contacts() const {
  const std::size_t number = trace_.contacts.size();
  return fill(
      "Do the robots also hold the object in place? A robot on an edge makes one contact, in an inward corner two; at an outward corner it is not counted (the safe side): {contacts} for {robots}. Before the first contact, the object can turn about any point, either way.",
      {counted(number, "contact"), counted(count_robots(placement_.teams), "robot")});
}

std::string StepCaptions::cut() const {
  const Contact& contact = trace_.contacts[item_];
  const std::string text = fill(
      "Contact {contact}, robot {robot} on edge {edge}. It pushes along its normal line: the object can turn clockwise only about points to the right of the line, counter-clockwise only about points to the left.",
      {counted_from_1(item_), whole(placement_.number_of(contact.point)),
       counted_from_1(contact.edge)});
  if (detail_.clockwise.has_area && detail_.counterclockwise.has_area)
    return sentences(
        {text,
         "It can still turn clockwise about some points, and counter-clockwise about others."});
  return sentences(
      {text, left("clockwise", detail_.clockwise, detail_.clockwise_before),
       left("counter-clockwise", detail_.counterclockwise, detail_.counterclockwise_before)});
}

std::string StepCaptions::left(const char* sense, const FreeRegion& region, bool before) {
  if (!region.exists)
    return fill(before ? "It can no longer turn {sense} about any point."
                       : "Turning {sense} is already ruled out.",
                {sense});
  if (region.has_area) return fill("It can still turn {sense} about some points.", {sense});
  return fill(region.clipped.size() == 1 ? "It can turn {sense} only about a single point."
                                         : "It can turn {sense} only about points on a line.",
              {sense});
}

std::string StepCaptions::slide() const {
  if (const auto& way = placement_.closure.translation)
    return fill("It can slide: no contact blocks the direction ({x}, {y}).",
                {with_decimals(way->x, 3), with_decimals(way->y, 3)});
  return "It cannot slide: every direction is blocked by a contact.";
}

std::string StepCaptions::closure() const {
  const Closure& closure = placement_.closure;
  const Piece margin = margin_text(closure.margin.value_or(0));
  if (closure.form_closure)
    return fill(
        "No centre to turn about, no way to slide: first-order form closure, with a margin of {margin}, as long as no robot gives way.",
        {margin});
  return sentences({fill("No form closure: the object can begin to {motions}.",
                         {free_motions_in_words(closure)}),
                    closure.margin
                        ? fill("The margin is {margin}; form closure needs more than 0.", {margin})
                        : ""});
}

std::string StepCaptions::second_order() const {
  return placement_.closure.second_order
             ? "Yet every motion that is left jams as soon as it begins: it curves into a robot. The object is immobile to second order."
             : "Nor does the curvature of these motions stop them: the object is not held to second order, either.";
}

std::string StepCaptions::result() const {
  const std::string text = verdict_of(placement_);
  if (!trace_.moved) return text;
  return sentences(
      {text, "Then robots were moved by hand. Where they stand now:", verdict_of(*trace_.moved)});
}

}  // namespace evenlift
