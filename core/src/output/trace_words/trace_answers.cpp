// Why a team stands there, for readers who do not know the algorithm.
#include <algorithm>
#include <string>

#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/why_not.h"
#include "output/trace_words/step_words.h"
#include "output/words/listed.h"

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

namespace {

// What a rule compares first. Without a default, the compiler requires a sentence for each rule.
const char* value_by(Rule rule) {
  switch (rule) {
    case Rule::longest_even:
    case Rule::longest:
      return "For team {team}, candidate {candidate} has a length of {value}.";
    case Rule::most_even:
      return "For team {team}, candidate {candidate} has a load ratio of {value}.";
    case Rule::score:
      return "For team {team}, candidate {candidate} has a score of {value}.";
  }
  return "";
}

// Why a candidate wins by a rule, in a question and in an answer.
struct Aim {
  const char *asked, *told;
};
Aim aim(const Trace& trace, Rule rule) {
  switch (rule) {
    case Rule::longest_even:
      return {"The one that is the longest even one.", "of those left, it is the longest even one"};
    case Rule::longest:
      return {"The one that is the longest one.", "of those left, it is the longest one"};
    case Rule::most_even:
      return {"The one that is the most even one.", "of those left, it is the most even one"};
    case Rule::score:
      break;
  }
  const MetricWords words = words_of(trace.metric());
  return {words.asked, words.wins};
}

std::string behind(const Trace& trace, const WhyNot& answer) {
  const Piece own = counted_from_1(*answer.candidate), winner = counted_from_1(*answer.winner);
  const Piece team = counted_from_1(answer.team);
  const Candidate &a = trace.placement.candidates[*answer.candidate],
                  &b = trace.placement.candidates[*answer.winner];
  switch (answer.decided_by) {
    case DecidedBy::ratio:
      return fill(
          "For team {team}, candidate {candidate} ties with candidate {winner}, which is more even, {ratio} against {other_ratio}.",
          {team, own, winner, ratio_text(b.chord.ratio, a.chord.ratio),
           ratio_text(a.chord.ratio, b.chord.ratio)});
    case DecidedBy::length:
      return fill(
          "For team {team}, candidate {candidate} ties with candidate {winner}, which is longer, {length} against {other_length}.",
          {team, own, winner, number_unlike(b.length, a.length, trace.polygon().diagonal()),
           number_unlike(a.length, b.length, trace.polygon().diagonal())});
    case DecidedBy::order:
      return fill(
          "For team {team}, candidate {candidate} ties in everything with candidate {winner}, which comes first in order of slope.",
          {team, own, winner});
    default:
      break;
  }
  return sentences(
      {fill(value_by(answer.rule),
            {team, own,
             score_or_bound(score_text(trace, answer.rule, answer.value, answer.best),
                            answer.exact)}),
       fill(
           "Candidate {winner}, which it takes, has {best}. Candidate {candidate} is number {rank} of those that were left.",
           {winner, score_text(trace, answer.rule, answer.best, answer.value), own,
            counted_from_1(answer.rank)})});
}

// For the step that shows the chord of two balanced robots.
std::string chord_question(const Trace& trace, const StepDetail& detail) {
  const BalancedDetail& balanced = *detail.balanced;
  if (balanced.moved.empty())
    return sentences({fill("Which chord makes the best set of {robots}?",
                           {counted(balanced.robots.size(), "robot")}),
                      goal_of(trace.placement.settings) == Goal::hold
                          ? "Aim for a strong hold, then for coverage."
                          : "Aim for coverage."});
  return sentences({fill(balanced.moved.size() == 1
                             ? "Robot {robots} moves, and one robot takes the place with the ring."
                             : "Robots {robots} move, and one robot takes the place with the ring.",
                         {numbers_from_1(balanced.moved)}),
                    "Which chord with M in its middle should two robots take for the best set?"});
}

std::string why_no_candidate(const Trace& trace, const WhyNot& answer) {
  const double least = trace.placement.settings.min_ratio;
  switch (answer.why) {
    case Why::no_chord:
      return written(
          "In this direction the boundary is not on both sides of C: no team can stand there.");
    case Why::no_pair:
      return written(
          "Its ends are not on two edges that face each other: an edge whose line passes through C is in no edge pair.");
    case Why::too_uneven:
      return fill(
          "Ratio too low: this chord has {ratio}. Edges {a} and {b} allow at most {best}, below the minimum {least}.",
          {ratio_text(answer.chord.ratio, least), counted_from_1(trace.pairs[*answer.pair].a),
           counted_from_1(trace.pairs[*answer.pair].b), ratio_text(answer.pair_ratio, least),
           exact(least)});
    case Why::opposite_too_uneven:
      return fill(
          "Ratio too low: this chord between two opposite vertices has {ratio}, below the minimum {least}.",
          {ratio_text(answer.chord.ratio, least), exact(least)});
    case Why::not_best_of_pair:
      return fill(
          "Not the best of its edge pair: this chord has a load ratio of {ratio}. Edges {a} and {b} give one candidate, number {candidate} with {best}.",
          {ratio_text(answer.chord.ratio, answer.pair_ratio),
           counted_from_1(trace.pairs[*answer.pair].a), counted_from_1(trace.pairs[*answer.pair].b),
           counted_from_1(*answer.candidate), ratio_text(answer.pair_ratio, answer.chord.ratio)});
    case Why::duplicate:
      return fill(
          "A duplicate: it is the same chord as candidate {candidate}, which counts for both.",
          {counted_from_1(*answer.candidate)});
    default:
      return written("Robots of this size cannot stand at both of its ends.");
  }
}

// Or why the candidate was chosen.
std::string why_not_chosen(const Trace& trace, const WhyNot& answer) {
  switch (answer.why) {
    case Why::not_even:
      return fill(
          "The first team takes the longest even candidate. Candidate {candidate} has a load ratio of {ratio}; candidate {winner} is even.",
          {counted_from_1(*answer.candidate), ratio_text(answer.chord.ratio),
           counted_from_1(*answer.winner)});
    case Why::collides:
      return fill(
          "A robot at one of its ends would be too close to one of the teams before team {team}.",
          {counted_from_1(answer.team)});
    case Why::behind:
      return behind(trace, answer);
    default:
      return fill("Team {team} takes candidate {candidate}: {merit}.",
                  {counted_from_1(answer.team), counted_from_1(*answer.candidate),
                   answer.decided_by == DecidedBy::only_one ? "of those left, it is the only one"
                   : answer.decided_by == DecidedBy::first_key
                       ? aim(trace, answer.rule).told
                       : "of those left, it wins the tie for the best"});
  }
}

std::string compared(const SetComparison& sets) {
  const BalancedKeys &other = sets.keys, &now = sets.keys_now;
  const auto fail = [](int steady) { return whole(static_cast<std::size_t>(std::max(0, steady))); };
  switch (sets.decided_by) {
    case BalancedKey::near_pairs:
      return fill("{pairs} of robots would be too close to each other, instead of {present}",
                  {counted(other.near_pairs, "pair"), whole(now.near_pairs)});
    case BalancedKey::steady:
      return fill("the object would stay steady if {robots} fail, instead of {present}",
                  {fail(other.steady), fail(now.steady)});
    case BalancedKey::level:
      return fill("the margin would be {margin} instead of {present}",
                  {margin_text(sets.margin.value_or(0)), margin_text(sets.margin_now.value_or(0))});
    case BalancedKey::coverage: {
      const int decimals = percentage(other.coverage) == percentage(now.coverage) ? 3 : 0;
      return fill("the coverage would be {coverage} instead of {present}",
                  {percentage(other.coverage, decimals), percentage(now.coverage, decimals)});
    }
    case BalancedKey::spread:
      return sets.better ? "the coverage would be the same, and they would stand farther from C"
                         : "the coverage would be the same, but they would stand nearer to C";
    case BalancedKey::places:
      break;
  }
  return "they would be as good as the present robots";
}

}  // namespace

std::string question_text(const Trace& trace, const StepDetail& detail, const Question& question) {
  if (question.kind == QuestionKind::nearer_end)
    return written(
        "None of the chords between these two sections is even. Which end is more even?");
  if (question.kind == QuestionKind::even_chord) return chord_question(trace, detail);
  if (detail.swap) return swap_question(detail, question);
  return sentences(
      {fill("Which candidate does team {team} take?", {counted_from_1(detail.step.item)}),
       aim(trace, detail.scores->rule).asked});
}

std::string why_not_text(const Trace& trace, const WhyNot& answer) {
  switch (answer.why) {
    case Why::no_chord:
    case Why::no_pair:
    case Why::too_uneven:
    case Why::opposite_too_uneven:
    case Why::not_best_of_pair:
    case Why::duplicate:
    case Why::cannot_stand:
      return why_no_candidate(trace, answer);
    case Why::not_by_candidates:
      return fill(
          "Load ratio {ratio}. The method “{method}” does not choose among candidates.",
          {ratio_text(answer.chord.ratio), method_in_words(trace.placement.settings.method)});
    case Why::not_even:
    case Why::behind:
    case Why::taken:
    case Why::collides:
      return why_not_chosen(trace, answer);
  }
  return {};
}

std::string why_no_robot_text(const Trace& trace, const WhyNoRobot& answer) {
  const Piece robot = counted_from_1(answer.robot);
  switch (answer.why) {
    case WhyNoRobot::Why::no_set:
      return written("There are fewer than three robots, so none can move.");
    case WhyNoRobot::Why::stands_from_start:
      return fill(
          "Robot {robot} has stood here since the first set: no swap that moved it was better.",
          {robot});
    case WhyNoRobot::Why::stands:
      return fill(
          "Robot {robot} came here in round {round}, with swap {swap} of {swaps}. No later swap that moved it was better.",
          {robot, counted_from_1(trace.history.moves[answer.move].round),
           counted_from_1(answer.move), whole(trace.history.moves.size())});
    case WhyNoRobot::Why::no_completion:
      return written(
          "With a robot here, no two others make C the centroid of all again: whichever three leave, no chord of the object has the required point M in its middle.");
    case WhyNoRobot::Why::other_set:
      break;
  }
  const std::size_t move = answer.set.came.size() - 1;
  return sentences(
      {fill(
           move == 0
               ? "With a robot here, the other {others} could stay where they are, so that C stays the centroid."
           : move == 1
               ? "With a robot here, at best {others} of the others could stay, and one would have to move to the ring, so that C stays the centroid."
               : "With a robot here, at best {others} of the others could stay, and two would have to move to the rings, so that C stays the centroid.",
           {whole(answer.set.kept.size())}),
       fill("Then {result}.", {compared(answer.comparison)}),
       answer.comparison.better
           ? fill(
                 "That would be better, but the search tries {points} points, and this place is not one of them.",
                 {whole(trace.history.stands)})
           : ""});
}

std::string even_chord_text(const Trace& trace, const StepDetail& detail, std::uint32_t choice) {
  return fill("With chord {chord}, {result}.",
              {counted_from_1(choice), compared(compare_even_chord(trace, detail, choice))});
}

}  // namespace evenlift
