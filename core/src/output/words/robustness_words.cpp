#include "evenlift/output/robustness_words.h"

#include <algorithm>
#include <array>
#include <limits>

#include "evenlift/capacity.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/tilt.h"
#include "evenlift/tolerance.h"
#include "evenlift/uncertainty.h"
#include "evenlift/wording.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

using Robots = std::vector<std::size_t>;

std::string springs_in_words(const SpringLoads& springs, const Units& units) {
  const auto [least, greatest] = std::minmax_element(springs.loads.begin(), springs.loads.end());
  const std::string text = say(
      "If all robots are equally stiff and level and the object does not bend, they carry {loads} "
      "each.",
      {load_in_words(*least, *greatest, *greatest, units)});
  Robots idle;
  for (std::size_t i = 0; i < springs.loads.size(); ++i)
    if (springs.loads[i] == 0) idle.push_back(i + 1);
  if (idle.empty()) return text;
  return text + " " +
         say(idle.size() == 1 ? "Robot {robots} goes slack." : "Robots {robots} go slack.",
             {listed(idle)});
}

// "five", or digits above twelve.
std::string in_letters(std::size_t number) {
  constexpr std::array<const char*, 13> words = {"no",   "one",    "two",   "three", "four",
                                                 "five", "six",    "seven", "eight", "nine",
                                                 "ten",  "eleven", "twelve"};
  return number < words.size() ? words[number] : std::to_string(number);
}

// After a failure, disturbed or not.
double greatest_after(const RestOfRobots& rest) {
  return std::max(rest.greatest_by_springs, rest.greatest_end.value_or(0));
}
bool is_disturbed(const RestOfRobots& rest) {
  return greatest_after(rest) > rest.greatest_by_springs;
}

std::string robots_or(const Robots& robots) {
  return say(robots.size() == 1 ? "robot {robots}" : "any of robots {robots}", {listed(robots)});
}

// The numbers of failures ignore the given conditions.
std::string presuming(const std::string& may_fail, const Shown& shown) {
  const bool level = disturbance_of(shown).besides_com(), exact = shown.com_radius > 0;
  return level && exact ? say("{failures}, on level ground and with C as given", {may_fail})
         : level        ? say("{failures}, on level ground", {may_fail})
         : exact        ? say("{failures}, with C as given", {may_fail})
                        : may_fail;
}

}  // namespace

std::string model_in_words(LoadModel model, const ModelLoads& loads, const Units& units) {
  switch (model) {
    case LoadModel::plan:
      return {};
    case LoadModel::springs:
      return springs_in_words(loads.springs, units);
    case LoadModel::best:
      return say("However well the weight is shared, some robot carries at least {load}.",
                 {load_in_words(loads.best, units, Toward::down)});
    case LoadModel::worst: {
      const double greatest = *std::max_element(loads.worst.begin(), loads.worst.end());
      return say(
          "On level ground and with C as given, a robot may have to carry up to {load} if heights "
          "are unequal or the object bends.",
          {load_in_words(greatest, units, Toward::up)});
    }
  }
  return {};
}

std::string uncertainty_in_words(const ModelLoads& loads, const Robustness& robustness,
                                 const Shown& shown) {
  if (!loads.disturbance.any()) return {};
  const Units& units = shown.units;
  const SpringLoads& springs = loads.springs;
  const double tips_at = robustness.tipping_distance, reach = loads.changes.effect.reach;
  if (!loads.disturbance.besides_com() && reach >= tips_at)
    return tips_at == 0 ? say("Even the smallest error of C can tip the object.")
                        : say("If C is off by {distance} or more, the object can tip.",
                              {length_in_words(tips_at, units, Toward::down)});
  if (reach > tips_at) return {};  // the first sentence says that it tips
  const std::vector<LoadRange> ranges = load_ranges(springs.loads, loads.changes);
  const bool slack = may_let_go(springs.loads, loads.changes);
  double greatest = 0, change = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    greatest = std::max(greatest, ranges[i].greatest);
    change = std::max({change, loads.changes.by[i], springs.loads[i] - ranges[i].least});
  }
  if (slack) {
    const std::string text = say(
        "If {conditions}, one of equally stiff robots may go slack, and another may have to carry "
        "up to {load}.",
        {disturbance_as_clause(shown), load_in_words(greatest, units, Toward::up)});
    // The tilt of an uneven object is bounded while all robots carry (uncertainty.h).
    return loads.changes.effect.tilt > 0
               ? text + " " + say("It can then also tilt by more than was counted.")
               : text;
  }
  return say("If {conditions}, the loads of equally stiff robots change by up to {load}.",
             {disturbance_as_clause(shown), load_in_words(change, units, Toward::up)});
}

std::string uncertainty_for_capacity_in_words(const ModelLoads& loads, const ShownPlacement& of) {
  const Units& units = of.shown.units;
  const bool has_own = has_own_capacities(of);
  const std::string limit = has_own ? "their capacities" : given_weight(*of.shown.capacity, units);
  const auto capacities = capacities_of(of);
  const auto radius = com_radius_within(of, loads, capacities);
  if (!radius) {
    const bool certain = disturbance_in_words(of.shown).empty();
    if (has_own)
      return say(certain ? "If all robots are equally stiff, some carry more than they can."
                         : "If all robots are equally stiff, some may carry more than they can.");
    return say(certain ? "If all robots are equally stiff, some carry more than {limit}."
                       : "If all robots are equally stiff, some may carry more than {limit}.",
               {limit});
  }
  // The range may end where loads farther out are unknown, rather than at the capacity.
  const bool ends_known =
      *radius ==
      com_radius_within(of, loads, std::vector<std::optional<double>>(capacities.size()));
  return say(ends_known ? "Equally stiff robots stay within {limit} as long as C is off by at most "
                          "{distance}; beyond that, a robot may go slack or the object may "
                          "tip, and loads were not computed."
                        : "Equally stiff robots stay within {limit} as long as C is off by at most "
                          "{distance}.",
             {limit, length_in_words(*radius, units, Toward::down)});
}

std::string failures_in_words(const std::vector<std::optional<RestOfRobots>>& failures,
                              const Units& units, const std::vector<bool>& overloads,
                              const std::string& limit, const std::string& conditions) {
  Robots needed, tips, for_steadiness, for_capacity;
  double greatest = 0;
  bool disturbed = false;
  for (std::size_t i = 0; i < failures.size(); ++i) {
    if (!failures[i]) {
      needed.push_back(i + 1);
      continue;
    }
    if (!failures[i]->stays) {
      tips.push_back(i + 1);
      continue;
    }
    if (!failures[i]->clear) for_steadiness.push_back(i + 1);
    if (i < overloads.size() && overloads[i]) for_capacity.push_back(i + 1);
    greatest = std::max(greatest, greatest_after(*failures[i]));
    disturbed = disturbed || is_disturbed(*failures[i]);
  }
  if (needed.size() == failures.size()) return say("The object falls whichever robot fails.");
  const std::string most =
      say(disturbed ? "at most {load} each if equally stiff, within the given conditions"
                    : "at most {load} each if equally stiff",
          {load_in_words(greatest, units, Toward::up)});
  if (tips.size() == failures.size())
    return say("Whichever robot fails, it tips {conditions}.", {conditions});
  std::string text;
  if (!needed.empty()) text = say("The object falls if {robots} fails.", {robots_or(needed)}) + " ";
  if (!tips.empty())
    text += say("If {robots} fails, it tips {conditions}.", {robots_or(tips), conditions}) + " ";
  if (needed.size() + tips.size() == failures.size()) {
    text.pop_back();
    return text;
  }
  text += text.empty() ? say("Whichever robot fails, the others carry the object, {most}.", {most})
                       : say("If another fails, the others carry it, {most}.", {most});
  if (!for_steadiness.empty())
    text += " " + say("It can tip if {robots} fails.", {robots_or(for_steadiness)});
  if (!for_capacity.empty())
    text +=
        " " + say(disturbed ? "Some robot can come to carry more than {limit} if {robots} fails."
                            : "Some robot carries more than {limit} if {robots} fails.",
                  {limit, robots_or(for_capacity)});
  return text + " " +
         say("At a sudden failure loads swing beyond this, those of the nearest robots by about "
             "twice the change, others by more.");
}

std::string failure_in_words(std::size_t robot, std::size_t robots,
                             const std::optional<RestOfRobots>& rest,
                             const std::optional<double>& capacity, const Units& units,
                             const std::string& conditions) {
  const std::string others = in_letters(robots - 1);
  if (robots == 1) return say("Robot {robot} fails: nothing else carries the object.", {robot + 1});
  if (!rest)
    return robots == 2
               ? say("Robot {robot} fails: the other one cannot carry the object.", {robot + 1})
               : say("Robot {robot} fails: the other {number} cannot carry the object.",
                     {robot + 1, others});
  if (!rest->stays)
    return say("Robot {robot} fails: it tips {conditions}.", {robot + 1, conditions});
  const double greatest = greatest_after(*rest);
  const std::string most =
      say(is_disturbed(*rest) ? "at most {load} each within the given conditions"
                              : "at most {load} each",
          {load_in_words(greatest, units, Toward::up)});
  const bool can_tip = !rest->clear;
  const std::string text =
      robots == 2
          ? say(can_tip
                    ? "Robot {robot} fails: the other one carries the object, {most}, but it can "
                      "tip."
                    : "Robot {robot} fails: the other one carries the object, {most}.",
                {robot + 1, most})
          : say(can_tip
                    ? "Robot {robot} fails: the other {number} carry the object, {most}, but it "
                      "can tip."
                    : "Robot {robot} fails: the other {number} carry the object, {most}.",
                {robot + 1, others, most});
  return capacity && exceeds(greatest, *capacity)
             ? text + " " + say("Capacity: {capacity}.", {given_weight(*capacity, units)})
             : text;
}

std::string rest_in_words(const ShownPlacement& of) {
  const Placement& failing = of.placement;
  if (!failing.loads)
    return say("The centre of mass is outside the remaining lifting base, so the object falls.");
  return coverage_in_words(failing) + " " + closure_in_words(of);
}

std::vector<Fact> robustness_facts(const ShownPlacement& of, const Robustness& robustness,
                                   bool failing) {
  if (of.placement.teams.empty() || (!of.placement.loads && !failing)) return {};
  // Barely steady does not count.
  const auto number = [](int failures) { return static_cast<std::size_t>(std::max(failures, 0)); };
  const std::size_t carried = number(robustness.failures_carried),
                    steady = number(robustness.failures_clear);
  const std::string may_fail =
      failing             ? say("one fails now")
      : carried == 0      ? say("none")
      : steady >= carried ? say("any {number}", {carried})
      : steady == 0       ? say("any {number}, but it can tip then", {carried})
                          : say("any {steady}; any {carried} if it may tip", {steady, carried});
  std::vector<Fact> facts = {
      {"Robots that may fail", failing || carried == 0 ? may_fail : presuming(may_fail, of.shown),
       "If this number of robots fails at once, whichever they are, the others carry the object, if "
       "none is overloaded"},
      {"Tipping distance",
       length_in_words(robustness.tipping_distance, of.shown.units, Toward::down),
       "If C is farther off than this, the object can tip; nearer it does not, if robots push back "
       "and none is overloaded"}};
  const auto tilt = tilt_of(disturbance_of(of.shown), {}, robustness.tipping_distance,
                            of.placement.polygon().diameter());
  if (tilt)
    facts.push_back(
        {"It tips on a slope of",
         degrees_in_words(tilt->degrees) + " (" + slope_in_words(tilt->slope, Toward::down) + ")",
         "In the worst direction, at rest. On level ground it tips when it is braked at that ratio "
         "in g: 25 % means 0.25 g"});
  return facts;
}

}  // namespace evenlift
