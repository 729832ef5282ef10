// Captions of the outline, holes, cargo and C; caption and formula of the boundary that robots with
// a size can use.
#include <cmath>
#include <string>
#include <utility>

#include "evenlift/output/words.h"
#include "evenlift/stands.h"
#include "output/trace_words/step_captions.h"
#include "output/trace_words/step_formulas.h"

namespace evenlift {
namespace {

// As seen from C, to the nearest eighth of a turn.
const char* side_of(const Vec2& way) {
  constexpr double flat = 0.41421356;  // tangent of half the angle between two directions
  const double across = std::fabs(way.x), along = std::fabs(way.y);
  if (along <= flat * across)
    return way.x > 0 ? "to the right of the centre of mass" : "to the left of the centre of mass";
  if (across <= flat * along)
    return way.y > 0 ? "straight up from the centre of mass"
                     : "straight down from the centre of mass";
  if (way.y > 0)
    return way.x > 0 ? "to the upper right of the centre of mass"
                     : "to the upper left of the centre of mass";
  return way.x > 0 ? "to the lower right of the centre of mass"
                   : "to the lower left of the centre of mass";
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
      return fill("{share} is no-go, and no robot may touch it", {lost});
    case WhyUnusable::body:
      return fill("at {share} a body of radius {radius} would meet another part of the boundary",
                  {lost, size(robot.radius)});
    case WhyUnusable::arm:
      return fill("at {share} an arm of reach {reach} would cross the object",
                  {lost, size(robot.reach)});
    case WhyUnusable::corner:
      return fill("at {share} a hand of width {width} would stick out beyond a corner",
                  {lost, size(robot.width)});
    case WhyUnusable::hand:
      return fill("at {share} a hand of depth {depth} would stick out", {lost, size(robot.depth)});
    case WhyUnusable::hole:
      return fill("at {share} a hand of depth {depth} would reach into a hole",
                  {lost, size(robot.depth)});
    case WhyUnusable::near_no_go:
      return fill("at {share} a hand of width {width} would reach a no-go part",
                  {lost, size(robot.width)});
    case WhyUnusable::narrow:
      break;
  }
  return fill("{share} is too short for a robot between its neighbours", {lost});
}

}  // namespace

std::string StepCaptions::polygon() const {
  std::size_t reflex = 0;
  const std::size_t n = trace_.polygon().size(), holes = trace_.object().holes().size();
  for (std::size_t i = 0; i < n; ++i) reflex += trace_.polygon().turn(i) == Turn::reflex;
  const std::string area = fill("The object: a polygon with {vertices} and an area of {area}.",
                                {counted(n, "vertex"), area_text(trace_, trace_.object().area())});
  const char* moved =
      trace_.moved
          ? "Robots were moved by hand. The steps show where the method puts them; the last step also describes where they stand now."
          : "";
  if (holes == 0)
    return sentences(
        {area,
         reflex == 0
             ? "It is convex."
             : fill(reflex == 1 ? "It is not convex: {corners} of its corners points inwards."
                                : "It is not convex: {corners} of its corners point inwards.",
                    {whole(reflex)}),
         moved});
  return sentences(
      {area,
       fill(holes == 1 ? "It has {holes}, whose area does not count."
                       : "It has {holes}, and their area does not count.",
            {counted(holes, "hole")}),
       reflex == 0
           ? "Its outline is convex."
           : fill(reflex == 1
                      ? "Its outline is not convex: {corners} of its corners points inwards."
                      : "Its outline is not convex: {corners} of its corners point inwards.",
                  {whole(reflex)}),
       moved});
}

std::string StepCaptions::centroid() const {
  const std::size_t holes = trace_.object().holes().size();
  return sentences(
      {"The centroid is the point where the area balances.",
       holes == 0
           ? "Cut the polygon into triangles that share vertex 1 and average their centroids, weighted by area; triangles that fold back count as negative."
       : holes == 1
           ? "Cut the polygon into triangles that share vertex 1 and average their centroids, weighted by area, minus the triangles of the hole; triangles that fold back count with the opposite sign."
           : "Cut the polygon into triangles that share vertex 1 and average their centroids, weighted by area, minus the triangles of the holes; triangles that fold back count with the opposite sign.",
       fill("The centroid is {point}.", {point_text(trace_, trace_.object().centroid())})});
}

std::string StepCaptions::own_centre() const {
  const double moved = length(placement_.own_centre - trace_.object().centroid());
  if (moved == 0) return {};
  return fill(
      "The object alone has its centre of mass at {point}, {distance} from the centroid: it is heavier on that side.",
      {point_text(trace_, placement_.own_centre), length_text(trace_, moved)});
}

std::string StepCaptions::cargo() const {
  const Cargo& item = placement_.settings.cargo[item_];
  const Vec2 before = with_cargo(item_).centre, after = with_cargo(item_ + std::size_t{1}).centre;
  const Vec2 way = item.at - before;
  const std::string cargo = cargo_text(trace_, item_), own = item_ == 0 ? own_centre() : "",
                    weight = given_weight(item.weight, trace_.units);
  const Piece at = point_text(trace_, item.at);
  if (before == after)
    return sentences(
        {own,
         fill("{cargo} weighs {weight} at {point}, at the centre of mass, which stays where it is.",
              {cargo, weight, at})});
  const std::string from = written(point_text(trace_, before)),
                    to = written(point_text(trace_, after));
  if (from == to)
    return sentences(
        {own,
         fill(
             "{cargo} weighs {weight} at {point}, {beside_centre} at {from}, which moves towards it by only {way}.",
             {cargo, weight, at, side_of(way), from, significant(length(after - before), 3)})});
  return sentences(
      {own,
       fill(
           "{cargo} weighs {weight} at {point}, {beside_centre}, which moves towards it from {from} to {to}.",
           {cargo, weight, at, side_of(way), from, to})});
}

std::string StepCaptions::with_all_cargo() const {
  return fill(
      "With its cargo the object weighs {weight}. Its centre of mass C is at {point}, {distance} from that of the object alone.",
      {given_weight(placement_.weight(), trace_.units), point_text(trace_, trace_.centre),
       length_text(trace_, length(trace_.centre - placement_.own_centre))});
}

std::string StepCaptions::what_c_is() const {
  const double moved = length(trace_.centre - trace_.object().centroid());
  return sentences(
      {!placement_.settings.cargo.empty() ? with_all_cargo()
       : moved == 0
           ? fill("The centre of mass C is the centroid, {point}.",
                  {point_text(trace_, trace_.centre)})
           : fill(
                 "The centre of mass C is at {point}, {distance} from the centroid: the object is heavier on that side.",
                 {point_text(trace_, trace_.centre), length_text(trace_, moved)}),
       centre_is_outside(trace_) ? "It lies outside the polygon." : "",
       trace_.object().hole_around(trace_.centre) ? "It lies in a hole." : ""});
}

std::string StepCaptions::centre() const {
  return sentences(
      {what_c_is(),
       trace_.balanced()
           ? fill("Where must {robots} stand on the boundary so that all can carry the same load?",
                  {counted(placement_.settings.robots, "robot")})
       : trace_.given()
           ? fill(
                 "{robots} already stand: does the object stand on them, and what does each carry?",
                 {counted(count_robots(placement_.teams), "robot")})
           : "Two robots carry the object without tipping it only if C is between them: a team stands at the two ends of a chord through C."});
}

// --- Where robots with a size can stand

std::string StepCaptions::stands() const {
  const StandsDetail& stands = *detail_.stands;
  const RobotSize& robot = placement_.stands->robot();
  std::string reasons;
  for (std::size_t why = 0; why < why_unusable_count; ++why) {
    if (!(stands.lost[why] > 0)) continue;
    reasons += (reasons.empty() ? "" : "; ") + lost_in_words(static_cast<WhyUnusable>(why),
                                                             stands.lost[why] / stands.boundary,
                                                             robot, trace_.units);
  }
  const double apart = 2 * robot.radius + robot.gap, clear = robot.radius + robot.gap;
  return sentences(
      {fill("Robots take room: {share} of the boundary can be used.",
            {percentage(stands.usable / stands.boundary)}),
       reasons.empty() ? "" : as_a_sentence(std::move(reasons)),
       apart > 0 ? fill("The middles of two robots stay at least {distance} apart.",
                        {with_length_unit(plain(apart), trace_.units)})
                 : "",
       !(robot.reach > 0) ? ""
       : clear > 0
           ? fill(
                 "An arm stays {distance} away from the middles of other robots, and arms do not cross.",
                 {with_length_unit(plain(clear), trace_.units)})
           : "Arms do not cross."});
}

std::string StepFormulas::stands() const {
  const RobotSize& robot = placement_.stands->robot();
  std::string text;
  const double away = robot.radius + robot.reach;
  if (away > 0) text = fill("s = c + (radius + reach) n = c + {away} n", {exact(away)});
  if (robot.depth > 0)
    text +=
        (text.empty() ? "" : ", ") + fill("p = c − depth n = c − {depth} n", {exact(robot.depth)});
  return text;
}

}  // namespace evenlift
