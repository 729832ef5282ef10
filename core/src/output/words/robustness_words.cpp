#include "evenlift/output/robustness_words.h"

#include <algorithm>
#include <array>
#include <limits>

#include "evenlift/capacity.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/tilt.h"
#include "evenlift/uncertainty.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

using Robots = std::vector<std::size_t>;

// A length by itself.
std::string length_in_words(double length, const Units& units) {
  return with_length_unit(amount(length, length), units);
}

std::string springs_in_words(const SpringLoads& springs, const Units& units) {
  const auto [least, greatest] = std::minmax_element(springs.loads.begin(), springs.loads.end());
  std::string text =
      "If all robots are equally stiff and level and the object does not bend, they carry " +
      load_in_words(*least, *greatest, *greatest, units) + " each.";
  Robots idle;
  for (std::size_t i = 0; i < springs.loads.size(); ++i)
    if (springs.loads[i] == 0) idle.push_back(i + 1);
  if (idle.empty()) return text;
  return text + (idle.size() == 1 ? " Robot " : " Robots ") + listed(idle) +
         (idle.size() == 1 ? " goes slack." : " go slack.");
}

// "five", or digits for numbers above twelve.
std::string in_letters(std::size_t number) {
  constexpr std::array<const char*, 13> words = {"no",   "one",    "two",   "three", "four",
                                                 "five", "six",    "seven", "eight", "nine",
                                                 "ten",  "eleven", "twelve"};
  return number < words.size() ? words[number] : std::to_string(number);
}

// The greatest load after a failure, within the disturbance.
double greatest_after(const RestOfRobots& rest) {
  return std::max(rest.greatest_by_springs, rest.greatest_end);
}
bool is_disturbed(const RestOfRobots& rest) { return rest.greatest_end > rest.greatest_by_springs; }

std::string robots_or(const Robots& robots) {
  return (robots.size() == 1 ? "robot " : "any of robots ") + listed(robots);
}

}  // namespace

std::string model_in_words(LoadModel model, const ModelLoads& loads, const Units& units) {
  switch (model) {
    case LoadModel::plan:
      return {};
    case LoadModel::springs:
      return springs_in_words(loads.springs, units);
    case LoadModel::best:
      return "However well the weight is shared, some robot carries at least " +
             load_in_words(loads.best, loads.best, units) + ".";
    case LoadModel::worst: {
      const double greatest = *std::max_element(loads.worst.begin(), loads.worst.end());
      return "If the robots' heights are unequal or the object bends, a robot may have to carry up to " +
             load_in_words(greatest, greatest, units) + ".";
    }
  }
  return {};
}

std::string uncertainty_in_words(const ModelLoads& loads, const Robustness& robustness,
                                 const Shown& shown) {
  if (!loads.disturbance.any()) return {};
  const Units& units = shown.units;
  const SpringLoads& springs = loads.springs;
  const bool slack = may_let_go(springs.loads, loads.changes);
  const bool only_centre = loads.disturbance == Disturbance{.reach = shown.com_radius};
  double greatest = 0, change = 0;
  const std::vector<LoadRange> ranges = load_ranges(springs.loads, loads.changes);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    greatest = std::max(greatest, ranges[i].greatest);
    change = std::max(change, loads.changes.by[i]);
    if (!slack) change = std::max(change, springs.loads[i] - ranges[i].least);
  }
  const std::string most = load_in_words(greatest, greatest, units) + ".";
  if (slack && !only_centre)
    return "If " + disturbance_as_clause(shown) +
           ", one of equally stiff robots may go slack, and another may have to carry up to " +
           most;
  std::string text = "If " + disturbance_as_clause(shown) +
                     ", the loads of equally stiff robots change by up to " +
                     load_in_words(change, change, units) + ".";
  if (only_centre) {
    if (robustness.tipping_distance == 0)
      return text + " Even the smallest error can tip the object.";
    if (shown.com_radius >= robustness.tipping_distance)
      return text + " From " + length_in_words(robustness.tipping_distance, units) +
             " on, the object can tip.";
  }
  if (!slack) return text;
  return text + " One of them may go slack then, and another may have to carry up to " + most;
}

std::string uncertainty_for_capacity_in_words(const ModelLoads& loads, const ShownPlacement& of) {
  const Units& units = of.shown.units;
  const bool has_own = has_own_capacities(of);
  const std::string limit = has_own ? std::string() : given_weight(*of.shown.capacity, units);
  const auto capacities = capacities_of(of);
  const auto radius = com_radius_within(of, loads, capacities);
  if (!radius)
    return "If all robots are equally stiff, some " +
           std::string(disturbance_in_words(of.shown).empty() ? "carry more than "
                                                              : "may carry more than ") +
           (has_own ? "they can" : limit) + ".";
  // Loads farther out are unknown; this may end the range, rather than the capacity.
  const bool ends_known =
      *radius ==
      com_radius_within(of, loads, std::vector<std::optional<double>>(capacities.size()));
  return "Equally stiff robots stay within " + (has_own ? "their capacities" : limit) +
         " as long as C is off by at most " + length_in_words(*radius, units) +
         (ends_known ? "; beyond that, loads are not known in advance." : ".");
}

std::string failures_in_words(const std::vector<std::optional<RestOfRobots>>& failures,
                              const Units& units, const std::vector<bool>& overloads,
                              const std::string& limit) {
  Robots needed, for_steadiness, for_capacity;
  double greatest = 0;
  bool disturbed = false;
  for (std::size_t i = 0; i < failures.size(); ++i) {
    if (!failures[i]) {
      needed.push_back(i + 1);
      continue;
    }
    if (!failures[i]->clear || !failures[i]->stays) for_steadiness.push_back(i + 1);
    if (i < overloads.size() && overloads[i]) for_capacity.push_back(i + 1);
    greatest = std::max(greatest, greatest_after(*failures[i]));
    disturbed = disturbed || is_disturbed(*failures[i]);
  }
  if (needed.size() == failures.size()) return "The object falls whichever robot fails.";
  const std::string most = "at most " + load_in_words(greatest, greatest, units) +
                           " each if equally stiff" +
                           (disturbed ? ", within the given conditions." : ".");
  std::string text = needed.empty() ? "Whichever robot fails, the others carry the object, " + most
                                    : "The object falls if " + robots_or(needed) +
                                          " fails. If another fails, the others carry it, " + most;
  if (!for_steadiness.empty()) text += " It can tip if " + robots_or(for_steadiness) + " fails.";
  if (!for_capacity.empty())
    text += " Some robot carries more than " + limit + " if " + robots_or(for_capacity) + " fails.";
  return text + " A sudden failure can briefly double the change of load.";
}

std::string failure_in_words(std::size_t robot, std::size_t robots,
                             const std::optional<RestOfRobots>& rest,
                             const std::optional<double>& capacity, const Units& units) {
  const std::string fails = "Robot " + std::to_string(robot + 1) + " fails: ";
  const std::string others = "the other " + in_letters(robots - 1);
  if (!rest) return fails + others + " cannot carry the object.";
  const double greatest = greatest_after(*rest);
  const std::string overload = capacity && exceeds(greatest, *capacity)
                                   ? " Capacity: " + given_weight(*capacity, units) + "."
                                   : std::string();
  return fails + others + (robots == 2 ? " carries" : " carry") + " the object, at most " +
         load_in_words(greatest, greatest, units) + " each" +
         (is_disturbed(*rest) ? " within the given conditions" : "") +
         (rest->clear && rest->stays ? "." : ", but it can tip.") + overload;
}

std::string rest_in_words(const ShownPlacement& of) {
  const Placement& failing = of.placement;
  if (!failing.loads)
    return "The centre of mass is outside the remaining lifting base, so the object falls.";
  return coverage_in_words(failing) + " " + closure_in_words(of);
}

std::vector<Fact> robustness_facts(const ShownPlacement& of, const Robustness& robustness,
                                   bool failing) {
  if (of.placement.teams.empty() || (!of.placement.loads && !failing)) return {};
  // Barely steady does not count.
  const int carried = robustness.failures_carried, steady = robustness.failures_clear;
  std::string may_fail = carried < 1 ? "none" : "any " + std::to_string(carried);
  if (carried > 0 && steady > 0 && steady < carried)
    may_fail =
        "any " + std::to_string(steady) + "; any " + std::to_string(carried) + " if it may tip";
  else if (carried > 0 && steady < carried)
    may_fail += ", but it can tip then";
  if (failing) may_fail = "one fails now";
  std::vector<Fact> facts = {
      {"Robots that may fail", may_fail,
       "If this number of robots fails at once, whichever they are, the others carry the object, if "
       "none is overloaded"},
      {"Tipping distance", length_in_words(robustness.tipping_distance, of.shown.units),
       "If C is farther off than this, the object can tip; nearer it does not, if robots push back "
       "and none is overloaded"}};
  const auto tilt =
      tilt_of(of.shown, robustness.tipping_distance, of.placement.polygon().diameter());
  if (tilt)
    facts.push_back(
        {"It tips on a slope of",
         degrees_in_words(tilt->degrees) + " (" + slope_in_words(tilt->slope) + ")",
         "In the worst direction, at rest. On level ground it tips when it is braked at that ratio "
         "in g: 25 % means 0.25 g"});
  return facts;
}

}  // namespace evenlift
