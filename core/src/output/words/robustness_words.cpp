#include "evenlift/output/robustness_words.h"

#include <algorithm>
#include <array>
#include <limits>

#include "evenlift/output/carrying_words.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

using Robots = std::vector<std::string>;  // what people call them

std::string springs_in_words(const Placement& placement, const SpringLoads& springs,
                             const Units& units) {
  const auto [least, greatest] = std::minmax_element(springs.loads.begin(), springs.loads.end());
  const std::string text = say(
      "If all robots are equally stiff and level and the object does not bend, they carry {loads} "
      "each.",
      {load_in_words(*least, *greatest, *greatest, units)});
  Robots idle;
  for (std::size_t i = 0; i < springs.loads.size(); ++i)
    if (springs.loads[i] == 0) idle.push_back(placement.called(i));
  if (idle.empty()) return text;
  return text + " " +
         say(idle.size() == 1 ? "Robot {robots} goes slack." : "Robots {robots} go slack.",
             {listed_briefly(idle)});
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
  return say(robots.size() == 1 ? "robot {robots}" : "any of robots {robots}",
             {listed_briefly(robots)});
}

std::string loads_if_disturbed(const Reported& of) {
  const ModelLoads& loads = *of.report.models;
  const Units& units = of.shown.units;
  const SpringLoads& springs = loads.springs;
  const double tips_at = of.report.robustness.tipping_distance, reach = loads.changes.effect.reach;
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
        {disturbance_as_clause(of.shown), load_in_words(greatest, units, Toward::up)});
    // The tilt of an uneven object is bounded while all robots carry (uncertainty.h).
    return loads.changes.effect.tilt > 0
               ? text + " " + say("It can then also tilt by more than was counted.")
               : text;
  }
  return say("If {conditions}, the loads of equally stiff robots change by up to {load}.",
             {disturbance_as_clause(of.shown), load_in_words(change, units, Toward::up)});
}

std::string uncertainty_for_capacity(const Reported& of) {
  const Units& units = of.shown.units;
  const bool has_own = of.report.has_own_capacities;
  const std::string limit = has_own ? "their capacities" : given_weight(*of.shown.capacity, units);
  const auto& [radius, known] = *of.report.com_radius;
  if (!radius) {
    return has_own
               ? say("If all robots are equally stiff, some may carry more than they can.")
               : say("If all robots are equally stiff, some may carry more than {limit}.", {limit});
  }
  // The range may end where loads farther out are unknown, rather than at the capacity.
  const bool ends_known = radius == known;
  return say(ends_known ? "Equally stiff robots stay within {limit} as long as C is off by at most "
                          "{distance}; beyond that, a robot may go slack or the object may "
                          "tip, and loads were not computed."
                        : "Equally stiff robots stay within {limit} as long as C is off by at most "
                          "{distance}.",
             {limit, length_in_words(*radius, units, Toward::down)});
}

}  // namespace

std::string model_in_words(const Reported& of) {
  if (!of.report.models) return {};
  const ModelLoads& loads = *of.report.models;
  const Units& units = of.shown.units;
  switch (of.report.model) {
    case LoadModel::plan:
      return {};
    case LoadModel::springs:
      return springs_in_words(of.placement, loads.springs, units);
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

std::string uncertainty_in_words(const Reported& of) {
  if (!of.report.models || !of.report.disturbance.any()) return {};
  std::string text = loads_if_disturbed(of);
  if (of.report.has_capacities && !of.report.tips)
    text += (text.empty() ? "" : " ") + uncertainty_for_capacity(of);
  return text;
}

std::string failures_in_words(const Reported& of) {
  const auto& failures = of.report.failures;
  if (failures.empty()) return {};
  const Units& units = of.shown.units;
  const auto& overloaded = of.report.overloaded_after;
  const std::string limit = of.report.has_capacities ? limit_in_words(of) : std::string(),
                    conditions = conditions_in_words(of.shown);
  Robots needed, tips, for_steadiness, for_capacity;
  double greatest = 0;
  bool disturbed = false;
  for (std::size_t i = 0; i < failures.size(); ++i) {
    if (!failures[i]) {
      needed.push_back(of.placement.called(i));
      continue;
    }
    if (!failures[i]->stays) {
      tips.push_back(of.placement.called(i));
      continue;
    }
    if (!failures[i]->clear) for_steadiness.push_back(of.placement.called(i));
    if (i < overloaded.size() && !overloaded[i].empty())
      for_capacity.push_back(of.placement.called(i));
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

std::string failure_in_words(const ShownPlacement& of, std::size_t robot,
                             const std::optional<RestOfRobots>& rest) {
  const std::size_t robots = count_robots(of.placement.teams);
  const Units& units = of.shown.units;
  const std::optional<double>& capacity = of.shown.capacity;
  const std::string conditions = conditions_in_words(of.shown);
  const std::string others = in_letters(robots - 1);
  const std::string number = of.placement.called(robot);
  if (robots == 1) return say("Robot {robot} fails: nothing else carries the object.", {number});
  if (!rest)
    return robots == 2
               ? say("Robot {robot} fails: the other one cannot carry the object.", {number})
               : say("Robot {robot} fails: the other {number} cannot carry the object.",
                     {number, others});
  if (!rest->stays) return say("Robot {robot} fails: it tips {conditions}.", {number, conditions});
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
                {number, most})
          : say(can_tip
                    ? "Robot {robot} fails: the other {number} carry the object, {most}, but it "
                      "can tip."
                    : "Robot {robot} fails: the other {number} carry the object, {most}.",
                {number, others, most});
  return capacity && exceeds(greatest, limit_of(*capacity, of.shown.carrying))
             ? text + " " + say("Capacity: {capacity}.", {given_weight(*capacity, units)})
             : text;
}

std::string rest_in_words(const Reported& of) {
  const Placement& failing = of.placement;
  if (!failing.loads)
    return say("The centre of mass is outside the remaining lifting base, so the object falls.");
  return coverage_in_words(failing) + " " + closure_in_words(of);
}

namespace {

// As the subject and verb of a sentence.
std::string first_to_fail(const Placement& placement, const Accuracy::First& first) {
  const auto number = [&](std::size_t i) { return placement.called(first.robots[i]); };
  switch (first.what) {
    case Promise::fits:
      return first.robots.size() == 1 ? say("robot {robot} may have no room", {number(0)})
                                      : say("robots {a} and {b} may come too near to each other",
                                            {number(0), number(1)});
    case Promise::stands:
      return say("the object may tip over the line from robot {a} to robot {b}",
                 {number(0), number(1)});
    case Promise::hold:
      return say("the robots may no longer hold it");
    case Promise::capacity:
      return say("robot {robot} may be overloaded", {number(0)});
  }
  return {};
}

// The limit that is worth telling.
const Accuracy::First* limit_of(const Reported& of) {
  const auto& first = of.report.accuracy.first;
  const bool is_told = first && first->within > near_distance(of.placement.polygon().diameter());
  return is_told ? &*first : nullptr;
}

// What ends within the accuracy that is asked for.
std::string broken_in_words(const Reported& of) {
  const Accuracy& all = of.report.accuracy;
  if (all.keeps_asked(near_distance(of.placement.polygon().diameter()))) return {};
  return say("With robots off by {distance} or more, {problem}.",
             {promised_length(all.first->within, of.shown.units),
              first_to_fail(of.placement, *all.first)});
}

// For the accuracy that is asked for.
std::string with_asked(const Reported& of) {
  const Accuracy& all = of.report.accuracy;
  const Units& units = of.shown.units;
  if (of.placement.teams.empty()) return {};
  if (std::string broken = broken_in_words(of); !broken.empty()) return broken;
  const std::string asked = with_length_unit(plain(all.asked), units);
  if (!all.greatest)
    return say("With robots off by up to {distance} all of this still holds.", {asked});
  return say(
      "With robots off by up to {distance} all of this still holds; robot {robot} then carries up "
      "to about {load}.",
      {asked, of.placement.called(all.greatest->robot),
       load_in_words(all.greatest->load, units, Toward::up)});
}

}  // namespace

std::string inaccuracy_in_words(const Reported& of) { return broken_in_words(of); }

std::string accuracy_in_words(const Reported& of) {
  const Accuracy& all = of.report.accuracy;
  if (all.asked > 0) return with_asked(of);
  // closure_in_words() says it.
  const bool is_said = all.first && all.first->what == Promise::hold && !of.report.firm;
  if (is_said) return {};
  const Accuracy::First* first = limit_of(of);
  if (!first) return {};
  const std::string within = promised_length(first->within, of.shown.units);
  const std::vector<std::size_t>& exact = all.in_notches;
  constexpr std::size_t most_named = 6;
  if (exact.empty())
    return say("All of this holds if robots stand within {distance} of their places.", {within});
  if (exact.size() > most_named)
    return say(
        "All of this holds if robots stand within {distance} of their places, and those in inward "
        "corners stay there.",
        {within});
  return say(
      exact.size() == 1
          ? "All of this holds if robots stand within {distance} of their places, and robot "
            "{robots} stays in its inward corner."
          : "All of this holds if robots stand within {distance} of their places, and robots "
            "{robots} stay in their inward corners.",
      {within, numbers_of(of.placement, exact)});
}

std::string upright_in_words(const Reported& of) {
  if (of.placement.lifting_base.size() < 3) return {};
  const auto& line = of.report.tipping_line;
  if (!line || of.report.tips || of.report.upright) return {};
  return say("C is only {distance} inside the line from robot {a} to robot {b}.",
             {promised_length(line->distance, of.shown.units), of.placement.called(line->robots[0]),
              of.placement.called(line->robots[1])});
}

}  // namespace evenlift
