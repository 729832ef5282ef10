// Captions and formulas for given supports.
#include <algorithm>
#include <string>

#include "evenlift/output/words.h"
#include "output/trace_words/step_captions.h"
#include "output/trace_words/step_formulas.h"

namespace evenlift {

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
  return fill(pattern, {counted_from_1(item_), point_text(trace_, place.position)});
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
  const Reported of({placement_}, Asked{.models = true});
  const auto& models = of.report.models;
  return fill(
      "Other robots could share the weight differently. With ideal control, no robot would need to carry more than {best}. If their heights are unequal or the object bends, a robot may have to carry up to {worst}.",
      {load(models->best), load(*std::max_element(models->worst.begin(), models->worst.end()))});
}

std::string StepCaptions::falls() const {
  const Shown shown = shown_in(trace_.units);
  return loads_in_words({placement_, shown});
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
