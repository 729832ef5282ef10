// One to three sentences for each kind of step.
#include "output/trace_words/step_captions.h"

#include <algorithm>

#include "evenlift/angles.h"
#include "evenlift/output/words.h"
#include "evenlift/selection.h"
#include "evenlift/stability.h"
#include "evenlift/tolerance.h"

namespace evenlift {

Piece StepCaptions::load(double value) const { return weight_text(trace_, value); }

Piece StepCaptions::ratio(double value) const {
  return ratio_text(value, placement_.settings.min_ratio);
}

Piece StepCaptions::least() const { return exact(placement_.settings.min_ratio); }

std::string StepCaptions::radial() const {
  std::string list;
  const std::size_t shown = std::min<std::size_t>(trace_.radial_edges.size(), 6);
  for (std::size_t i = 0; i < shown; ++i)
    list += fill(i == 0 ? "#" : ", #", {counted_from_1(trace_.radial_edges[i])});
  if (shown < trace_.radial_edges.size()) list += ", …";
  return trace_.radial_edges.size() == 1
             ? fill(
                   "The line of edge # passes through C. Rays from C meet this edge only at its ends, so it faces no other edge.",
                   {list})
             : fill(
                   "The lines of edges # pass through C. Rays from C meet these edges only at their ends, so they face no other edge.",
                   {list});
}

std::string StepCaptions::ray() const {
  const std::uint32_t vertex = trace_.rays.vertices[item_];
  const std::uint32_t begin = trace_.rays.begins[item_], end = trace_.rays.begins[item_ + 1];
  std::string text = fill("From vertex # through C. ", {counted_from_1(vertex)});
  if (begin == end)
    return text + "Beyond C the ray does not meet the boundary: this vertex has no chord.";
  if (end == begin + 1) {
    const VertexChord& chord = trace_.rays.chords[begin];
    const std::uint32_t other = chord.vertex == vertex ? chord.hit_vertex : chord.vertex;
    text += other == inside_edge ? fill("Beyond C the ray meets the boundary at #",
                                        {point_text(trace_, far_end(chord.chord, vertex))})
                                 : fill("Beyond C the ray meets vertex #", {counted_from_1(other)});
    text += chord.vertex == vertex ? ": a chord with a load ratio of #."
                                   : ", where this chord was already found: load ratio #.";
    return fill(text, {ratio(chord.chord.ratio)});
  }
  constexpr std::uint32_t most = 5;
  std::string ratios;
  for (std::uint32_t i = begin; i < end && i < begin + most; ++i)
    ratios += fill(i == begin ? "#" : ", #", {ratio(trace_.rays.chords[i].chord.ratio)});
  if (end - begin > most) ratios += ", …";
  return text +
         fill("Beyond C the ray meets the boundary # times. Each hit makes a chord: load ratios #.",
              {whole(end - begin), ratios});
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
  return fill("The # in order of slope, from #° to #°. ",
              {counted(order.size(), "chord"), angle(order.front()), angle(order.back())}) +
         "Between two neighbouring chords no edge begins or ends: the same edges face each other.";
}

std::string StepCaptions::edges() const {
  return fill("edges # and #",
              {counted_from_1(detail_.pair->pair.a), counted_from_1(detail_.pair->pair.b)});
}

std::string StepCaptions::sections_before_choice() const {
  return fill(
      "Edge pair # of #: # face each other across C. The facing parts, called sections, end at two chords.",
      {counted_from_1(item_), whole(trace_.pairs.size()), edges()});
}

std::string StepCaptions::sections() const {
  std::string said = sections_before_choice();
  said.pop_back();
  return said + fill(" with load ratios # and #.",
                     {ratio(detail_.pair->ends[0].ratio), ratio(detail_.pair->ends[1].ratio)});
}

std::string StepCaptions::outcome() const {
  const PairDetail& pair = *detail_.pair;
  const Piece a = counted_from_1(pair.pair.a);
  const Piece b = counted_from_1(pair.pair.b);
  const Piece chosen = ratio(pair.chosen.ratio);
  const std::string off = fill(
      "Reflected through C, edge # meets the line of edge # outside the sections: none of their chords is even. ",
      {b, a});
  std::string text;
  switch (pair.outcome) {
    case Outcome::bisecting:
      text = fill(
          "Reflected through C, edge # meets edge # within the sections: C bisects the chord there. Equal arms, load ratio 1: a candidate.",
          {b, a});
      break;
    case Outcome::nearer_end:
      text = off + fill("The more even end has #, at least the minimum #: a candidate.",
                        {chosen, least()});
      break;
    case Outcome::too_uneven:
      text = off + fill("The more even end has only #, below the minimum #: no candidate here.",
                        {chosen, least()});
      break;
    case Outcome::midpoint:
      text = fill(
          "Edges # and # are parallel: all their chords have the load ratio #, at least the minimum #. The chord between the middles of the sections is the candidate.",
          {a, b, chosen, least()});
      break;
    case Outcome::parallel_low:
      text = fill(
          "Edges # and # are parallel: all their chords have the load ratio #, below the minimum #: no candidate here.",
          {a, b, chosen, least()});
      break;
  }
  if (pair.standing) text += standing(pair);
  if (!pair.candidate || pair.stands) return text;
  return text + same_chord(*pair.candidate);
}

// Whether robots with a size can stand there. Empty if the load ratio is already too low.
std::string StepCaptions::standing(const PairDetail& pair) const {
  switch (*pair.standing) {
    case Standing::there:
      return " Robots of this size can stand there.";
    case Standing::elsewhere:
      return fill(
          " Where robots of this size can stand, the best chord has #, at least the minimum #: it is the candidate.",
          {ratio(pair.chosen.ratio), least()});
    case Standing::nowhere:
      break;
  }
  return pair.verdict.candidate
             ? " But robots of this size cannot stand there, nor on another chord that meets the minimum ratio: no candidate."
             : "";
}

// The source of the chord that was kept for a candidate.
std::string StepCaptions::same_chord(std::uint32_t candidate) const {
  const std::uint32_t source = trace_.source_of_candidate[candidate];
  if (source == no_index) return {};  // edges that face each other only where the hands lift
  if (source < trace_.pairs.size())
    return fill(" Edge pair # has the same chord.", {counted_from_1(source)});
  const OppositeVertices& two = trace_.opposite[source - trace_.pairs.size()];
  return fill(" The opposite vertices # and # have the same chord, and theirs is kept.",
              {counted_from_1(two.v), counted_from_1(two.w)});
}

std::string StepCaptions::opposite() const {
  const OppositeDetail& opposite = *detail_.opposite;
  std::string text = fill(
      "Vertices # and # are opposite each other: the line between them passes through C. Rounding decides whether the edges that meet there also face each other, so the chord between the two vertices is a separate case. ",
      {counted_from_1(opposite.vertices.v), counted_from_1(opposite.vertices.w)});
  const Piece own = ratio(opposite.chord.ratio);
  if (!opposite.candidate && placement_.stands &&
      opposite.chord.ratio >= placement_.settings.min_ratio)
    return text + "Robots of this size cannot stand there: no candidate.";
  if (!opposite.candidate)
    return text +
           fill("Its load ratio is only #, below the minimum #: no candidate.", {own, least()});
  text += fill("Its load ratio is #, at least the minimum #: a candidate.", {own, least()});
  return opposite.stands ? text : text + same_chord(*opposite.candidate);
}

std::string StepCaptions::sources() const {
  if (trace_.opposite.empty()) return written(counted(trace_.pairs.size(), "edge pair"));
  return fill("# and # of opposite vertices",
              {counted(trace_.pairs.size(), "edge pair"), counted(trace_.opposite.size(), "pair")});
}

std::string StepCaptions::duplicates() const {
  std::size_t found = 2 * trace_.ranges.size();
  for (const std::uint32_t candidate : trace_.candidate_of_source) found += candidate != no_index;
  const std::size_t kept = placement_.candidates.size();
  if (found == 0) return "No edge pair and no pair of opposite vertices has a candidate.";
  if (found == kept)
    return fill("No chord was found twice: # from #.", {counted(kept, "candidate"), sources()});
  return fill(
      "# of the # chords found #, as at a vertex, where two edge pairs meet. Each chord counts once, which leaves #.",
      {whole(found - kept), whole(found), found - kept == 1 ? "repeats another" : "repeat others",
       counted(kept, "candidate")});
}

std::string StepCaptions::candidates() const {
  const std::vector<Candidate>& all = placement_.candidates;
  if (all.empty())
    return fill("There is no candidate: no chord through C has a load ratio of at least #.",
                {least()});
  std::size_t even = 0;
  for (const Candidate& candidate : all) even += is_even(candidate.chord);
  return fill("#, in order of slope. # even: equal loads for both robots.",
              {counted(all.size(), "candidate"),
               even == 0            ? "None of them is"
               : even == all.size() ? (even == 1 ? "It is" : "All of them are")
               : even == 1          ? "One of them is"
                                    : fill("# of them are", {whole(even)})});
}

std::string StepCaptions::directions() const {
  return fill(
      "Lines through C that meet the boundary on both sides of C span #° of 180°. The teams divide these directions equally.",
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
    text += i == 0 ? "Candidate " : ", candidate ";
    text += written(counted_from_1(order[i]));
    text += i > 0 ? " has "
            : scores.rule == Rule::longest_even || scores.rule == Rule::longest
                ? " has a length of "
            : scores.rule == Rule::most_even ? " has a load ratio of "
                                             : " has ";
    if (!score.exact) text += "at most ";
    text += written(score_text(trace_, scores.rule, score.value, neighbour(scores, i)));
  }
  return text + (order.size() > most ? ", and so on." : ".");
}

// The value of a ranking from which the i-th must look different: the nearest earlier value that
// differs, or for the first value the next.
double StepCaptions::neighbour(const TeamScores& scores, std::size_t i) {
  const auto value = [&](std::size_t j) { return scores.of_candidate[scores.ranking[j]].value; };
  for (std::size_t j = i; j-- > 0;)
    if (!lengths_tie(value(j), value(i))) return value(j);
  return i == 0 && scores.ranking.size() > 1 ? value(1) : value(i);
}

std::string StepCaptions::first_scores(const TeamScores& scores) const {
  if (scores.rule == Rule::longest_even)
    return "The first team takes the longest even candidate, for a wide lifting base. " +
           ranking(scores);
  if (scores.rule == Rule::longest)
    return "All candidates meet the minimum ratio, so the first team takes the longest, for a wide lifting base. " +
           ranking(scores);
  return "No candidate is even, so the first team takes the one with the largest load ratio. " +
         ranking(scores);
}

std::string StepCaptions::scores() const {
  const TeamScores& scores = *detail_.scores;
  if (item_ == 0) return first_scores(scores);
  return fill("Team #: how much would each candidate add? The score is #. ",
              {counted_from_1(scores.team), words_of(trace_.metric()).score}) +
         (scores.of_candidate[scores.ranking.front()].value > 0
              ? ranking(scores)
              : "No candidate adds anything more.");
}

std::string StepCaptions::team() const {
  if (!detail_.scores) return team_without_candidates();
  const TeamScores& scores = *detail_.scores;
  const std::uint32_t winner = scores.ranking.front();
  const std::string text =
      fill("Team # takes candidate #", {counted_from_1(scores.team), counted_from_1(winner)});
  if (scores.decided_by == DecidedBy::only_one) return text + ", the only one left.";
  const std::uint32_t second = scores.ranking[1];
  const Piece other = counted_from_1(second);
  const double best = scores.of_candidate[winner].value, next = scores.of_candidate[second].value;
  const Candidate &a = placement_.candidates[winner], &b = placement_.candidates[second];
  switch (scores.decided_by) {
    case DecidedBy::ratio:
      return text + fill(": it ties with candidate # but is more even, # against #.",
                         {other, ratio_text(a.chord.ratio, b.chord.ratio),
                          ratio_text(b.chord.ratio, a.chord.ratio)});
    case DecidedBy::length:
      return text + fill(": it ties with candidate # but is longer, # against #.",
                         {other, number_unlike(a.length, b.length, trace_.polygon().diagonal()),
                          number_unlike(b.length, a.length, trace_.polygon().diagonal())});
    case DecidedBy::order:
      return text +
             fill(": it ties with candidate # in everything but comes first in order of slope.",
                  {other});
    default:
      break;
  }
  if (!scores.of_candidate[second].eligible) return text + ", the only even one.";
  return text +
         fill(scores.rule == Rule::longest_even || scores.rule == Rule::longest
                  ? ", ## longer than candidate #."
                  : ", ## ahead of candidate #.",
              {scores.of_candidate[second].exact ? "" : "at least ",
               scores.rule == Rule::most_even ? ratio_text(best - next, 0)
                                              : score_text(trace_, scores.rule, best - next, 0),
               other});
}

std::string StepCaptions::team_without_candidates() const {
  const Chord chord = chord_of(placement_.teams[item_]);
  const Piece name = counted_from_1(item_);
  if (placement_.settings.method == Method::random)
    return fill(
        "Team #: one robot stands at a random point of the boundary, the other straight across C: # and #, load ratio #.",
        {name, point_text(trace_, chord.r1.position), point_text(trace_, chord.r2.position),
         ratio_text(chord.ratio)});
  return fill(
      "Team # of # takes the line at #°, with its robots at the farthest boundary points: load ratio #.",
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
      "The lifting base H, the convex hull of all robots, grows to # and covers # of the object.",
      {counted(detail_.base.size(), "corner"), covers});
}

std::string StepCaptions::fewer() const {
  if (placement_.teams.empty()) return verdict(placement_);
  return fill("Only # of the # requested teams: # left.",
              {whole(placement_.teams.size()), whole(placement_.requested_teams),
               trace_.by_candidates() ? "no candidate is" : "no further place was"});
}

std::string StepCaptions::share() const {
  const Team& team = placement_.teams[item_];
  const Piece item = counted_from_1(item_);
  const Piece all = load(placement_.weight() / static_cast<double>(placement_.teams.size()));
  const double first = team.robots[0].load, second = team.robots[1].load;
  if (is_even(chord_of(team)))
    return fill("Team # carries #, its share of #. Equal arms, equal loads: # for each robot.",
                {item, all, exact(placement_.weight()), load(first)});
  return fill(
      "Team # carries #, its share of #. By the law of the lever, the robot nearer to C carries more: # and #.",
      {item, all, exact(placement_.weight()), load(std::max(first, second)),
       load(std::min(first, second))});
}

std::string StepCaptions::loads() const {
  const LoadSummary& loads = *placement_.loads;
  if (trace_.given()) return loads_in_words(placement_);
  const std::string planned = "As planned, " + loads_in_words(placement_);
  if (trace_.balanced()) return planned;
  return planned +
         (written(load(loads.min)) == written(load(loads.max))
              ? " All carry the same load."
              : fill(" The arms are unequal, so the spread of loads is #.", {load(loads.spread)}));
}

std::string StepCaptions::coverage() const {
  if (placement_.lifting_base.size() < 3)
    return "All robots stand on one line, so H has no area: pressing down beside the line tips the object.";
  return fill(
      "H covers # of the object. Pressing down there does not tip it, as long as robots push back and none is overloaded.",
      {percent(placement_.coverage)});
}

std::string StepCaptions::contacts() const {
  const std::size_t number = trace_.contacts.size();
  return fill(
      "Do the robots also hold the object in place? A robot on an edge makes one contact, in an inward corner two; at an outward corner it is not counted (the safe side): # for #. Before the first contact, the object can turn about any point, either way.",
      {counted(number, "contact"), counted(count_robots(placement_.teams), "robot")});
}

std::string StepCaptions::cut() const {
  const Contact& contact = trace_.contacts[item_];
  std::string text = fill(
      "Contact #, # on edge #. It pushes along its normal line: the object can turn clockwise only about points to the right of the line, counter-clockwise only about points to the left. ",
      {counted_from_1(item_), robot_of_contact(contact), counted_from_1(contact.edge)});
  if (detail_.clockwise.has_area && detail_.counterclockwise.has_area)
    return text +
           "It can still turn clockwise about some points, and counter-clockwise about others.";
  return text + left("clockwise", detail_.clockwise, detail_.clockwise_before) + " " +
         left("counter-clockwise", detail_.counterclockwise, detail_.counterclockwise_before);
}

std::string StepCaptions::left(const char* sense, const FreeRegion& region, bool before) {
  if (!region.exists)
    return fill(
        before ? "It can no longer turn # about any point." : "Turning # is already ruled out.",
        {sense});
  if (region.has_area) return fill("It can still turn # about some points.", {sense});
  return fill(region.clipped.size() == 1 ? "It can turn # only about a single point."
                                         : "It can turn # only about points on a line.",
              {sense});
}

std::string StepCaptions::slide() const {
  if (const auto& way = placement_.closure.translation)
    return fill("It can slide: no contact blocks the direction (#, #).",
                {with_decimals(way->x(), 3), with_decimals(way->y(), 3)});
  return "It cannot slide: every direction is blocked by a contact.";
}

std::string StepCaptions::closure() const {
  const Closure& closure = placement_.closure;
  const Piece margin = margin_text(closure.margin.value_or(0));
  if (closure.form_closure)
    return fill(
        "No centre to turn about, no way to slide: first-order form closure, with a margin of #, as long as no robot gives way.",
        {margin});
  return fill("No form closure: the object can begin to #.", {free_motions_in_words(closure)}) +
         (closure.margin ? fill(" The margin is #; form closure needs more than 0.", {margin})
                         : "");
}

std::string StepCaptions::second_order() const {
  return placement_.closure.second_order
             ? "Yet every motion that is left jams as soon as it begins: it curves into a robot. The object is immobile to second order."
             : "Nor does the curvature of these motions stop them: the object is not held to second order, either.";
}

std::string StepCaptions::result() const {
  const std::string text = verdict(placement_);
  if (!trace_.moved) return text;
  return text + " Then robots were moved by hand. Where they stand now: " + verdict(*trace_.moved);
}

}  // namespace evenlift
