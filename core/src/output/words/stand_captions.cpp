// The caption and the formula of the step for robots with a size.
#include <string>
#include <utility>

#include "evenlift/output/words.h"
#include "evenlift/stands.h"
#include "output/words/step_captions.h"
#include "output/words/step_formulas.h"

namespace evenlift {
namespace {

std::string as_a_sentence(std::string words) {
  if (words[0] >= 'a' && words[0] <= 'z') words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words + ".";
}

std::string lost_in_words(WhyUnusable why, double share, const RobotSize& robot,
                          const Units& units) {
  const std::string lost = percentage(share);
  const auto size = [&](double value) { return with_length_unit(plain(value), units); };
  switch (why) {
    case WhyUnusable::no_go:
      return fill("# is no-go, and no robot may touch it", {lost});
    case WhyUnusable::body:
      return fill("at # a body of radius # would meet another part of the boundary",
                  {lost, size(robot.radius)});
    case WhyUnusable::arm:
      return fill("at # an arm of reach # would cross the object", {lost, size(robot.reach)});
    case WhyUnusable::corner:
      return fill("at # a hand of width # would stick out beyond a corner",
                  {lost, size(robot.width)});
    case WhyUnusable::hand:
      return fill("at # a hand of depth # would stick out", {lost, size(robot.depth)});
    case WhyUnusable::hole:
      return fill("at # a hand of depth # would reach into a hole", {lost, size(robot.depth)});
    case WhyUnusable::near_no_go:
      return fill("at # a hand of width # would reach a no-go part", {lost, size(robot.width)});
    case WhyUnusable::narrow:
      break;
  }
  return fill("# is too short for a robot between its neighbours", {lost});
}

}  // namespace

std::string StepCaptions::stands() const {
  const StandsDetail& stands = *detail_.stands;
  const RobotSize& robot = placement_.stands->robot();
  std::string text = fill("Robots take room: # of the boundary can be used.",
                          {percentage(stands.usable / stands.boundary)});
  std::string reasons;
  for (std::size_t why = 0; why < why_unusable_count; ++why) {
    if (!(stands.lost[why] > 0)) continue;
    reasons += (reasons.empty() ? "" : "; ") + lost_in_words(static_cast<WhyUnusable>(why),
                                                             stands.lost[why] / stands.boundary,
                                                             robot, trace_.units);
  }
  if (!reasons.empty()) text += " " + as_a_sentence(std::move(reasons));
  const double apart = 2 * robot.radius + robot.gap;
  if (apart > 0)
    text += fill(" The middles of two robots stay at least # apart.",
                 {with_length_unit(plain(apart), trace_.units)});
  const double clear = robot.radius + robot.gap;
  if (robot.reach > 0)
    text += fill(
        clear > 0 ? " An arm stays # away from the middles of other robots, and arms do not cross."
                  : " Arms do not cross.",
        {with_length_unit(plain(clear), trace_.units)});
  return text;
}

std::string StepFormulas::stands() const {
  const RobotSize& robot = placement_.stands->robot();
  std::string text;
  const double away = robot.radius + robot.reach;
  if (away > 0) text = fill("s = c + (radius + reach) n = c + # n", {exact(away)});
  if (robot.depth > 0)
    text += fill("#p = c − depth n = c − # n", {text.empty() ? "" : ", ", exact(robot.depth)});
  return text;
}

}  // namespace evenlift
