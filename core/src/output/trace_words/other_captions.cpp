// Captions of the outline, holes, cargo and C; caption and formula of the boundary that robots with
// a size can use.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "evenlift/output/words.h"
#include "evenlift/stands.h"
#include "output/trace_words/step_words.h"
#include "output/words/listed.h"

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

// --- Captions for ranges and swaps of teams.

std::string StepCaptions::range() const {
  const RangeDetail& range = *detail_.range;
  const Piece a = counted_from_1(range.pair.a), b = counted_from_1(range.pair.b);
  const auto [first, last] = range.candidates;
  return sentences(
      {fill(
           placement_.stands
               ? "A team need not stand at the best place on edges {a} and {b}: anywhere between these two chords, robots of this size can stand with a load ratio of at least {least}."
               : "A team need not stand at the best place on edges {a} and {b}: anywhere between these two chords, its load ratio is at least {least}.",
           {a, b, least()}),
       last == no_index
           ? fill(
                 "A sixteenth from one end, the range offers candidate {candidate}; at the other end, the team's two robots would collide.",
                 {counted_from_1(first)})
           : fill("A sixteenth from either end, the range offers candidates {first} and {second}.",
                  {counted_from_1(first), counted_from_1(last)})});
}

// Each moved team takes one of `to`.
std::string StepCaptions::moves_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  const std::string teams = numbers_from_1(swap.teams), to = numbers_from_1(swap.to);
  if (swap.kind == SwapKind::single)
    return fill("Team {team} swaps candidate {from} for candidate {to}.",
                {teams, counted_from_1(swap.from[0]), to});
  const bool pair = swap.kind == SwapKind::pair;
  const std::string move =
      swap.teams.size() == 1 ? fill("team {team} moves to candidate {candidate}", {teams, to})
      : pair                 ? fill("both teams move to candidates {candidates}", {to})
                             : fill("teams {teams} move to candidates {candidates}", {teams, to});
  return fill(pair ? "Of all pairs of candidates, the best is taken: {move}."
                   : "The result for one team fewer, with one more team added, is better: {move}.",
              {move});
}

std::string StepCaptions::gain_of_swap() const {
  const SwapDetail& swap = *detail_.swap;
  const auto coverage = told_apart(swap.before.coverage, swap.after.coverage);
  const Piece margin = margin_text(swap.margin.value_or(0));
  switch (swap.decided_by) {
    case HoldKey::level:
      return swap.before.level == 0
                 ? fill(
                       "Now the robots' contact holds the object, with a margin of {margin}; the coverage goes from {from} to {to}.",
                       {margin, coverage[0], coverage[1]})
                 : fill("The margin rises from {from} to {to}.",
                        {margin_text(swap.margin_before.value_or(0)), margin});
    case HoldKey::coverage:
      return fill(swap.after.level == 0
                      ? "The coverage rises from {from} to {to}; the hold is no better."
                      : "The coverage rises from {from} to {to}, and the hold is as strong.",
                  {coverage[0], coverage[1]});
    case HoldKey::ratios:
      break;
  }
  return "The hold and the coverage stay the same, and the teams share their loads more evenly.";
}

std::string StepCaptions::swap() const { return sentences({moves_of_swap(), gain_of_swap()}); }

std::string StepCaptions::held() const {
  const SwapHistory& history = *trace_.swaps;
  const std::string end = history.swaps.empty()
                              ? "No swap of a team for another candidate is better."
                              : fill("After {swaps}, no other swap is better.",
                                     {counted(history.swaps.size(), "swap")});
  return sentences(
      {history.settled ? end : "The search for better teams ends here.",
       placement_.closure.form_closure
           ? "The robots hold the object. With one team more they would still hold it, though all teams might differ."
           : "The robots do not bring it into form closure, and no choice that was tried does."});
}

// --- Captions and formulas for given supports.

std::string StepCaptions::support() const {
  const LiftingPoint& place = placement_.teams[0].robots[item_].point;
  const bool touches = std::any_of(trace_.contacts.begin(), trace_.contacts.end(),
                                   [&](const Contact& contact) { return contact.point == item_; });
  const char* pattern =
      place.edge == beneath
          ? "Robot {robot} stands beneath the object, at {point}: it lifts, and touches nothing sideways."
      : touches
          ? "Robot {robot} stands at the edge, at {point}: it lifts there, and it can also push sideways."
          : "Robot {robot} stands at a corner, at {point}: it lifts there; a push from the side is not counted.";
  return fill(pattern, {whole(placement_.number_of(item_)), point_text(trace_, place.position)});
}

std::string StepCaptions::equations() const {
  const std::size_t robots = count_robots(placement_.teams);
  return sentences(
      {"The loads add up to the weight, and they balance about C from left to right and from front to back: "
       "three equations.",
       !placement_.loads
           ? "Robots only push up, and then no loads satisfy all three here."
           : fill(
                 loads_are_determined(placement_)
                     ? "They determine the loads of {robots} without any further assumption."
                     : "They do not determine the loads of {robots}: that depends on how the robots give way.",
                 {counted(robots, "robot")})});
}

std::string StepCaptions::by_lever() const {
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  return fill(
      "The law of the lever: the robot nearer to C carries more. Robot 1 carries {first}, robot 2 {second}.",
      {load(robots[0].load), load(robots[1].load)});
}

std::string StepCaptions::by_areas() const {
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  return fill(
      "C divides the triangle of the robots into three. Each robot's share is the triangle on the other side of C: {first}, {second} and {third}.",
      {load(robots[0].load), load(robots[1].load), load(robots[2].load)});
}

std::string StepCaptions::by_springs() const {
  return "Suppose that the robots are equally stiff and level, and the object does not bend. Then it is like a board "
         "on equal springs: it sinks and tilts until they balance it, and the farther a spring is pressed down, the "
         "more it carries.";
}

std::string StepCaptions::extremes() const {
  const auto& models = trace_.report.models;
  return fill(
      "Other robots could share the weight differently. With ideal control, no robot would need to carry more than {best}. If their heights are unequal or the object bends, a robot may have to carry up to {worst}.",
      {load(models->best), load(*std::max_element(models->worst.begin(), models->worst.end()))});
}

std::string StepFormulas::equations() const {
  const Vec2& centre = trace_.centre;
  return fill("Σ Wi = W = {weight}, Σ Wi xi = W × {x}, Σ Wi yi = W × {y}",
              {exact(placement_.weight()), number(centre.x, trace_.polygon().diameter()),
               number(centre.y, trace_.polygon().diameter())});
}

std::string StepFormulas::by_lever() const {
  const std::vector<Robot>& robots = placement_.teams[0].robots;
  const double whole = robots[0].arm + robots[1].arm;
  return fill("W1 = W |C p2| / |p1 p2| = {weight} × {arm} / {length} = {load}",
              {exact(placement_.weight()), length_text(trace_, robots[1].arm),
               length_text(trace_, whole), load(robots[0].load)});
}

std::string StepFormulas::by_areas() const {
  return fill("W1 = W × area(C p2 p3) / area(p1 p2 p3) = {load}",
              {load(placement_.teams[0].robots[0].load)});
}

std::string StepFormulas::by_springs() const {
  return "Wi = max(0, a + b · pi), with the same a and b for all robots";
}

std::string StepFormulas::extremes() const {
  return "at worst: Wi = W |C q| / |pi q|, where the line from pi through C leaves H at q";
}

}  // namespace evenlift
