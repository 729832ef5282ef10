// Questions, answers, and what a figure is.
#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "output/words/trace_text.h"

namespace evenlift {
namespace {

std::string edges_of(const Trace& trace, std::uint32_t pair) {
  return fill("Edges # and #",
              {counted_from_1(trace.pairs[pair].a), counted_from_1(trace.pairs[pair].b)});
}

// "the longest even candidate", and the like.
const char* aim(const Trace& trace, Rule rule) {
  if (rule == Rule::longest_even) return "is the longest even one";
  if (rule == Rule::most_even) return "is the most even one";
  switch (trace.placement.settings.method) {
    case Method::circle:
      return "adds the largest inscribed circles";
    case Method::distance:
      return "shortens the arms that tip the object by most";
    case Method::area:
    case Method::distributed:
    case Method::random:
    case Method::balanced:
      break;
  }
  return "adds the most area";
}

std::string behind(const Trace& trace, const WhyNot& answer) {
  const Piece own = counted_from_1(*answer.candidate), winner = counted_from_1(*answer.winner);
  const Piece team = counted_from_1(answer.team);
  const Candidate &a = trace.placement.candidates[*answer.candidate],
                  &b = trace.placement.candidates[*answer.winner];
  switch (answer.decided_by) {
    case DecidedBy::ratio:
      return fill("For team # candidate # ties with candidate #, which is more even: # to #.",
                  {team, own, winner, ratio_text(b.chord.ratio, a.chord.ratio),
                   ratio_text(a.chord.ratio, b.chord.ratio)});
    case DecidedBy::length:
      return fill("For team # candidate # ties with candidate #, which is longer: # to #.",
                  {team, own, winner, number_unlike(b.length, a.length, trace.polygon.diagonal()),
                   number_unlike(a.length, b.length, trace.polygon.diagonal())});
    case DecidedBy::order:
      return fill(
          "For team # candidate # ties with candidate # in everything, which comes first in order of slope.",
          {team, own, winner});
    default:
      break;
  }
  constexpr const char* what[] = {"length", "load ratio", "score"};
  return fill(
      "For team # candidate # has a # of ##, candidate # has # and wins; # of those left rank before it.",
      {team, own, what[static_cast<std::size_t>(answer.rule)], answer.exact ? "" : "at most ",
       score_text(trace, answer.rule, answer.value, answer.best), winner,
       score_text(trace, answer.rule, answer.best, answer.value), whole(answer.rank)});
}

std::string loaded(const Trace& trace, const Figure& figure) {
  const RobotOfTeam robot = find_robot(trace.placement.teams, *figure.item);
  std::string text =
      fill("Team #, robot #", {counted_from_1(robot.team), counted_from_1(robot.robot)});
  if (figure.value > 0) text += fill(": #", {kilograms_text(trace, figure.value)});
  return text;
}

}  // namespace

std::string question_text(const Trace& trace, const StepDetail& detail, const Question& question) {
  if (question.kind == QuestionKind::nearer_end)
    return "None of the chords between these two sections is even. Which end is nearer to it?";
  return fill("Which candidate does team # take? The one that #.",
              {counted_from_1(detail.step.item), aim(trace, detail.scores->rule)});
}

std::string why_not_text(const Trace& trace, const WhyNot& answer) {
  const double least = trace.placement.settings.min_ratio;
  switch (answer.why) {
    case Why::no_chord:
      return "In this direction the boundary is not on both sides of C: no team can stand there.";
    case Why::not_by_candidates:
      return fill("Load ratio #. The method “#” does not choose among candidates.",
                  {ratio_text(answer.chord.ratio), name(trace.placement.settings.method)});
    case Why::no_pair:
      return "Its ends are on no two edges that face each other: an edge whose line passes through C is in no pair.";
    case Why::too_uneven:
      return fill(
          "Ratio too low: this chord has #. #: the best chord between them has #, less than the minimum #.",
          {ratio_text(answer.chord.ratio, least), edges_of(trace, *answer.pair),
           ratio_text(answer.pair_ratio, least), exact(least)});
    case Why::opposite_too_uneven:
      return fill(
          "Ratio too low: this chord between two opposite vertices has #, less than the minimum #.",
          {ratio_text(answer.chord.ratio, least), exact(least)});
    case Why::not_best_of_pair:
      return fill(
          "Not the best of its pair: this chord has a load ratio of #. # give one candidate, number # with #.",
          {ratio_text(answer.chord.ratio, answer.pair_ratio), edges_of(trace, *answer.pair),
           counted_from_1(*answer.candidate), ratio_text(answer.pair_ratio, answer.chord.ratio)});
    case Why::duplicate:
      return fill("A duplicate: it is the same chord as candidate #, which stands for both.",
                  {counted_from_1(*answer.candidate)});
    case Why::not_even:
      return fill(
          "The first team is the longest even candidate. Candidate # has a load ratio of #; candidate # is even.",
          {counted_from_1(*answer.candidate), ratio_text(answer.chord.ratio),
           counted_from_1(*answer.winner)});
    case Why::behind:
      return behind(trace, answer);
    case Why::taken:
      return fill("Team # takes candidate #: of those left it #.",
                  {counted_from_1(answer.team), counted_from_1(*answer.candidate),
                   answer.decided_by == DecidedBy::only_one    ? "is the only one"
                   : answer.decided_by == DecidedBy::first_key ? aim(trace, answer.rule)
                                                               : "wins the tie for the best"});
  }
  return {};
}

std::string figure_text(const Trace& trace, const StepDetail& detail, const Figure& figure) {
  const std::uint32_t index = figure.item.value_or(0);
  const Piece item = counted_from_1(index);
  const double least = trace.placement.settings.min_ratio;
  switch (figure.kind) {
    case FigureKind::object:
      return "The object";
    case FigureKind::triangle:
      return fill("Triangle at edge #: ## of the area",
                  {item, figure.value < 0 ? "−" : "", percent(std::abs(figure.value))});
    case FigureKind::centroid:
      return fill("Centroid #", {point_text(trace, figure.points[0])});
    case FigureKind::centre:
      return fill("Centre of mass C #", {point_text(trace, trace.centre)});
    case FigureKind::vertex:
      return fill("Vertex # #", {item, point_text(trace, figure.points[0])});
    case FigureKind::radial_edge:
      return fill("Edge #, in line with C", {item});
    case FigureKind::ray:
      return fill("Ray from vertex # through C", {item});
    case FigureKind::chord:
      return fill(
          "Chord from vertex #, load ratio #",
          {counted_from_1(trace.rays.chords[index].vertex), ratio_text(figure.value, least)});
    case FigureKind::edge:
      return fill("Edge #", {item});
    case FigureKind::section:
      return fill("Section of edge #", {item});
    case FigureKind::reflected:
      return fill("Edge # reflected through C", {item});
    case FigureKind::section_end:
      return fill("End of the sections, load ratio #", {ratio_text(figure.value, least)});
    case FigureKind::bisecting:
      return "The chord between the edges' lines that C bisects";
    case FigureKind::chosen:
      return fill(detail.opposite ? "The chord between the two vertices, load ratio #"
                  : !figure.item  ? "The best chord of the pair, load ratio #"
                                  : "The pair's candidate, load ratio #",
                  {ratio_text(figure.value, least)});
    case FigureKind::candidate: {
      const double ratio = trace.placement.candidates[index].chord.ratio;
      const std::string text = fill("Candidate #, load ratio #", {item, ratio_text(ratio, least)});
      if (!detail.scores) return text;
      const Score& score = detail.scores->of_candidate[index];
      if (detail.scores->rule == Rule::most_even) return text;
      return text + fill(detail.scores->rule == Rule::score ? ", score ##" : ", length ##",
                         {score.exact ? "" : "at most ",
                          score_text(trace, detail.scores->rule, score.value, 0)});
    }
    case FigureKind::team:
      return fill("Team #, load ratio #", {item, ratio_text(figure.value, least)});
    case FigureKind::robot:
      return loaded(trace, figure);
    case FigureKind::gain_triangle:
    case FigureKind::gain_part:
      return fill(trace.placement.settings.method == Method::area
                      ? "Adds # of the object to H"
                      : "Triangle between H and the end",
                  {score_text(trace, Rule::score, figure.value, 0)});
    case FigureKind::gain_circle:
      return fill("Inscribed circle, radius #", {length_text(trace, figure.value)});
    case FigureKind::arm_before:
      return fill("Arm to H's edge: #", {length_text(trace, figure.value)});
    case FigureKind::arm_after:
      return fill("Arm to the new edge: #", {length_text(trace, figure.value)});
    case FigureKind::base_before:
      return "Lifting base H before";
    case FigureKind::base:
      return "Lifting base H";
    case FigureKind::contact: {
      const Contact& contact = trace.contacts[index];
      const RobotIndex robot = robot_of(contact);
      return fill("Contact #: team #, robot # on edge #",
                  {item, counted_from_1(robot.team), counted_from_1(robot.end),
                   counted_from_1(contact.edge)});
    }
    case FigureKind::normal:
      return fill("Normal line of contact #", {item});
    case FigureKind::clockwise:
      return "About these points it can turn clockwise";
    case FigureKind::counterclockwise:
      return "About these points it can turn counter-clockwise";
    case FigureKind::translation:
      return "A way to slide";
  }
  return {};
}

}  // namespace evenlift
