// The captions of the object's steps: the outline and its holes, the cargo, the centre of mass, and
// the boundary that robots with a size can use, with its formula.
#include <cmath>
#include <string>
#include <utility>

#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"
#include "evenlift/stands.h"
#include "output/trace_words/step_captions.h"
#include "output/trace_words/step_formulas.h"

namespace evenlift {
namespace {

// Where a point is on the drawing, seen from another, to the nearest of eight directions.
const char* side_of(const Vec2& way) {
  constexpr double flat = 0.41421356;  // the tangent of half the angle between two directions
  const double across = std::fabs(way.x()), along = std::fabs(way.y());
  if (along <= flat * across) return way.x() > 0 ? "to the right of" : "to the left of";
  if (across <= flat * along) return way.y() > 0 ? "straight up from" : "straight down from";
  if (way.y() > 0) return way.x() > 0 ? "to the upper right of" : "to the upper left of";
  return way.x() > 0 ? "to the lower right of" : "to the lower left of";
}

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

std::string StepCaptions::polygon() const {
  std::size_t reflex = 0;
  const std::size_t n = trace_.polygon().size(), holes = trace_.object().holes().size();
  for (std::size_t i = 0; i < n; ++i) reflex += trace_.polygon().turn(i) == Turn::reflex;
  const Piece it = holes == 0 ? "It" : "Its outline";
  return fill("The object: a polygon with # and an area of #. ",
              {counted(n, "vertex"), area_text(trace_, trace_.object().area())}) +
         (holes == 0 ? ""
                     : fill("It has #, # area does not count. ",
                            {counted(holes, "hole"), holes == 1 ? "whose" : "and their"})) +
         (reflex == 0 ? fill("# is convex.", {it})
                      : fill("# is not convex: # of its corners point#inwards.",
                             {it, whole(reflex), reflex == 1 ? "s " : " "})) +
         (trace_.moved
              ? " Robots were moved by hand. The steps show where the method puts them; the last step also describes where they stand now."
              : "");
}

std::string StepCaptions::centroid() const {
  const std::size_t holes = trace_.object().holes().size();
  return fill(
      "The centroid is the point where the area balances. Cut the polygon into triangles that share vertex 1 and average their centroids, weighted by area#; triangles that fold back #. The centroid is #.",
      {holes == 0   ? ""
       : holes == 1 ? ", minus the triangles of the hole"
                    : ", minus the triangles of the holes",
       holes == 0 ? "count as negative" : "count with the opposite sign",
       point_text(trace_, trace_.object().centroid())});
}

// The object's own centre of mass, if it was given.
std::string StepCaptions::own_centre() const {
  const double moved = length(placement_.own_centre - trace_.object().centroid());
  if (moved == 0) return {};
  return fill(
      "The object alone has its centre of mass at #, # from the centroid: it is heavier on that side. ",
      {point_text(trace_, placement_.own_centre), length_text(trace_, moved)});
}

std::string StepCaptions::cargo() const {
  const Cargo& item = placement_.settings.cargo[item_];
  const Vec2 before = with_cargo(item_).centre, after = with_cargo(item_ + std::size_t{1}).centre;
  const Vec2 way = item.at - before;
  const std::string text =
      (item_ == 0 ? own_centre() : "") +
      fill("# weighs # at #, ", {cargo_text(trace_, item_), given_weight(item.weight, trace_.units),
                                 point_text(trace_, item.at)});
  if (before == after) return text + "at the centre of mass, which stays where it is.";
  const std::string from = written(point_text(trace_, before)),
                    to = written(point_text(trace_, after));
  if (from == to)
    return text + fill("# the centre of mass at #, which moves towards it by only #.",
                       {side_of(way), from, significant(length(after - before), 3)});
  return text + fill("# the centre of mass, which moves towards it from # to #.",
                     {side_of(way), from, to});
}

std::string StepCaptions::with_all_cargo() const {
  return fill(
      "With its cargo the object weighs #. Its centre of mass C is at #, # from that of the object alone.",
      {given_weight(placement_.weight(), trace_.units), point_text(trace_, trace_.centre),
       length_text(trace_, length(trace_.centre - placement_.own_centre))});
}

std::string StepCaptions::what_c_is() const {
  const double moved = length(trace_.centre - trace_.object().centroid());
  std::string text =
      !placement_.settings.cargo.empty() ? with_all_cargo()
      : moved == 0
          ? fill("The centre of mass C is the centroid, #.", {point_text(trace_, trace_.centre)})
          : fill(
                "The centre of mass C is at #, # from the centroid: the object is heavier on that side.",
                {point_text(trace_, trace_.centre), length_text(trace_, moved)});
  if (centre_is_outside(trace_)) text += " It lies outside the polygon.";
  if (trace_.object().hole_around(trace_.centre)) text += " It lies in a hole.";
  return text;
}

std::string StepCaptions::centre() const {
  if (trace_.balanced())
    return what_c_is() +
           fill(" Where must # stand on the boundary so that all can carry the same load?",
                {counted(placement_.settings.robots, "robot")});
  if (trace_.given())
    return what_c_is() +
           fill(" # already stand: does the object stand on them, and what does each carry?",
                {counted(count_robots(placement_.teams), "robot")});
  return what_c_is() +
         " Two robots carry the object without tipping it only if C is between them: a team stands at the two ends of a chord through C.";
}

// --- Where robots with a size can stand

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
