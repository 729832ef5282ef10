#include "evenlift/output/requirements.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "document/stand_settings.h"
#include "evenlift/accuracy.h"
#include "evenlift/capacity.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/tilt.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

using Known = std::optional<double>;

bool has_robots(const ShownPlacement& of) { return !of.placement.teams.empty(); }

// The planned loads under all given conditions. Nothing if the object falls or tips under them.
std::optional<std::vector<LoadRange>> loads_of(const ShownPlacement& of) {
  if (!of.placement.loads || tips_when_disturbed(of)) return std::nullopt;
  return loads_when_disturbed(of);
}

Known greatest_load(const ShownPlacement& of) {
  const auto loads = loads_of(of);
  if (!loads) return std::nullopt;
  double greatest = 0;
  for (const LoadRange& load : *loads) greatest = std::max(greatest, load.greatest);
  return greatest;
}

Known least_load(const ShownPlacement& of) {
  const auto loads = loads_of(of);
  if (!loads) return std::nullopt;
  double least = loads->front().least;
  for (const LoadRange& load : *loads) least = std::min(least, load.least);
  return least;
}

Known within_capacity(const ShownPlacement& of) {
  const auto loads = loads_of(of);
  if (!loads) return 0;
  std::vector<double> greatest;
  for (const LoadRange& load : *loads) greatest.push_back(load.greatest);
  return overloaded_robots(of, greatest).empty() ? 1 : 0;
}

// Whether any one robot may fail, on level ground and under the given conditions.
Known steady(const ShownPlacement& of) {
  if (!has_robots(of) || robustness(of.placement).failures_clear < 1) return false;
  const Disturbance disturbance = disturbance_of(of.shown);
  if (!disturbance.any()) return true;
  const auto failures = single_failures(of.placement, disturbance);
  return std::all_of(failures.begin(), failures.end(),
                     [](const auto& rest) { return rest && rest->stays; });
}

Known greatest_after_failure(const ShownPlacement& of) {
  if (!of.placement.loads) return std::nullopt;
  double greatest = 0;
  for (const auto& rest : single_failures(of.placement, disturbance_of(of.shown))) {
    if (!rest || !rest->greatest_end) return std::nullopt;
    greatest = std::max(greatest, *rest->greatest_end);
  }
  return greatest;
}

// That statics allows; nothing if the object falls or tips.
Known worst_load(const ShownPlacement& of) {
  const auto loads = tips_when_disturbed(of) ? std::nullopt : worst_loads(of);
  return loads && !loads->empty() ? Known(*std::max_element(loads->begin(), loads->end()))
                                  : std::nullopt;
}

// In degrees, in the worst direction; nothing if the height of C is 0.
Known tipping_angle(const ShownPlacement& of) {
  const auto tilt = tilt_of(of);
  return tilt ? Known(tilt->degrees) : std::nullopt;
}

// How far robots may be off: infinite if there is no limit, nothing if the object falls or tips.
Known within(const ShownPlacement& of) {
  if (!of.placement.loads || tips_when_disturbed(of)) return std::nullopt;
  const auto first = accuracy(of).first;
  return first ? first->within : std::numeric_limits<double>::infinity();
}

// A value's unit, also of what rounding may change.
enum class Unit : std::uint8_t { none, number, share, weight, length, degrees };

struct Row {
  std::string_view name;
  std::string_view words;  // a sentence if it is yes or no, else its subject
  bool yes_or_no;
  Unit unit;
  Known (*value)(const ShownPlacement&);
};

// clang-format off
const Row rows[] = {
    {"held", "The robots hold the object", true, Unit::none,
     [](const ShownPlacement& of) -> Known { return has_robots(of) && is_held(of.placement); }},
    {"stands", "The object stands on its robots", true, Unit::none,
     [](const ShownPlacement& of) -> Known { return of.placement.loads.has_value(); }},
    {"steady", "Any one robot may fail without tipping the object", true, Unit::none, steady},
    {"upright", "The centre of mass is clearly inside the lifting base", true, Unit::none, [](const ShownPlacement& of) -> Known { return is_upright(of); }},
    {"capacity", "No robot carries more than its capacity", true, Unit::none, within_capacity},
    {"coverage", "The coverage", false, Unit::share, [](const ShownPlacement& of) -> Known { return of.placement.coverage; }},
    {"max", "The greatest load", false, Unit::weight, greatest_load},
    {"min", "The least load", false, Unit::weight, least_load},
    {"spread", "The greatest load minus the least", false, Unit::weight,
     [](const ShownPlacement& of) { return of.placement.loads ? Known(of.placement.loads->spread) : std::nullopt; }},
    {"max_after_failure", "The greatest load after any one failure", false, Unit::weight, greatest_after_failure},
    {"margin", "The margin of form closure", false, Unit::number, [](const ShownPlacement& of) { return of.placement.closure.margin; }},
    {"tipping_distance", "The tipping distance", false, Unit::length,
     [](const ShownPlacement& of) -> Known { return has_robots(of) ? robustness(of.placement).tipping_distance : 0; }},
    {"tip", "The slope at which it tips", false, Unit::degrees, tipping_angle},
    {"robots", "The number of robots", false, Unit::none,
     [](const ShownPlacement& of) -> Known { return static_cast<double>(count_robots(of.placement.teams)); }},
    {"within", "How far robots may be off", false, Unit::length, within},
    {"worst", "The greatest load that statics allows", false, Unit::weight, worst_load},
};
// clang-format on

const Row* find(std::string_view name) {
  const auto* row = std::find_if(std::begin(rows), std::end(rows),
                                 [&](const Row& each) { return each.name == name; });
  return row == std::end(rows) ? nullptr : row;
}

const Row& row_of(const Condition& condition) { return *find(condition.quantity); }

std::string names(bool yes_or_no) {
  std::string found[2];  // all but the last, and the last
  for (const Row& row : rows) {
    if (row.yes_or_no != yes_or_no) continue;
    if (!found[1].empty()) found[0] += (found[0].empty() ? "" : ", ") + found[1];
    found[1] = row.name;
  }
  return say_written(yes_or_no ? "{names} or {last}" : "{names} and {last}", found, 2);
}

std::optional<Condition> read_condition(const std::string& text) {
  const std::size_t sign = text.find_first_of("<>");
  const std::string_view name = std::string_view(text).substr(0, sign);
  const Row* row = find(name);
  if (!row || row->yes_or_no != (sign == std::string::npos)) return std::nullopt;
  if (row->yes_or_no) return Condition{row->name, true, 0, text};
  if (text.substr(sign + 1, 1) != "=") return std::nullopt;
  const auto limit = read_number(std::string_view(text).substr(sign + 2));
  if (!limit) return std::nullopt;
  return Condition{row->name, text[sign] == '>', *limit, text};
}

std::string without_spaces(std::string_view text) {
  std::string kept;
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') kept += c;
  return kept;
}

InputError refused(const std::string& condition) {
  const bool quotable = !condition.empty() && is_quotable(condition);
  const std::string values[] = {names(true), names(false), condition};
  return bad_setting(
      "require",
      say_written(quotable
                      ? "a condition must be {conditions}, or one of {quantities} with >= or <= "
                        "and a number, such as coverage>=0.8, not \"{condition}\""
                      : "a condition must be {conditions}, or one of {quantities} with >= or <= "
                        "and a number, such as coverage>=0.8",
                  values, quotable ? 3 : 2));
}

double in_unit(double value, Unit unit) { return unit == Unit::share ? 100 * value : value; }

std::string with_unit(const std::string& number, Unit unit, const Units& units) {
  switch (unit) {
    case Unit::share:
      return number + "\u00a0%";
    case Unit::weight:
      return with_weight_unit(number, units);
    case Unit::length:
      return with_length_unit(number, units);
    case Unit::degrees:
      return number + "°";
    case Unit::number:
    case Unit::none:
      break;
  }
  return number;
}

double slack(Unit unit, const Placement& placement) {
  switch (unit) {
    case Unit::share:
    case Unit::number:
      return tau;
    case Unit::weight:
      return tau * placement.weight();
    case Unit::length:
      return tau * placement.polygon().diameter();
    case Unit::degrees:
      return tau * 90;
    case Unit::none:
      break;
  }
  return 0;
}

// A value that misses its limit must not look the same, so it has 6 digits or as many as it takes.
std::string unlike_limit(double value, double limit) {
  int digits = 6;
  while (digits < 17 && significant(value, digits) == significant(limit, digits)) ++digits;
  return significant(value, digits);
}

}  // namespace

Result<std::vector<Condition>> read_conditions(std::string_view text) {
  std::vector<Condition> conditions;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string word = without_spaces(text.substr(0, comma));
    const auto condition = read_condition(word);
    if (!condition) return refused(word);
    if (conditions.size() == most_conditions)
      return bad_setting("require",
                         say("there are more than {most} conditions", {most_conditions}));
    conditions.push_back(*condition);
    if (comma == std::string_view::npos) return conditions;
    text.remove_prefix(comma + 1);
  }
}

bool is_yes_or_no(const Condition& condition) { return row_of(condition).yes_or_no; }

std::vector<Requirement> check_conditions(const ShownPlacement& of,
                                          const std::vector<Condition>& conditions) {
  std::vector<Requirement> requirements;
  for (const Condition& condition : conditions) {
    const Row& row = row_of(condition);
    Requirement requirement{condition, row.value(of), false};
    if (row.yes_or_no)
      requirement.kept = requirement.value == 1;
    else if (requirement.value)
      requirement.kept = (condition.at_least ? *requirement.value - condition.limit
                                             : condition.limit - *requirement.value) >=
                         -slack(row.unit, of.placement);
    requirements.push_back(std::move(requirement));
  }
  return requirements;
}

std::string condition_in_words(const Condition& condition, const Units& units) {
  const Row& row = row_of(condition);
  if (row.yes_or_no) return say(row.words);
  return say(
      condition.at_least ? "{quantity} is at least {limit}" : "{quantity} is at most {limit}",
      {row.words, with_unit(plain(in_unit(condition.limit, row.unit)), row.unit, units)});
}

std::string value_in_words(const Requirement& requirement, const Units& units) {
  if (!requirement.value) return {};
  if (is_yes_or_no(requirement.condition)) return *requirement.value == 1 ? "yes" : "no";
  if (std::isinf(*requirement.value)) return say("no limit");
  const Unit unit = row_of(requirement.condition).unit;
  const double value = in_unit(*requirement.value, unit);
  const double limit = in_unit(requirement.condition.limit, unit);
  const double largest = std::max(std::abs(value), std::abs(limit));
  std::string number = unit == Unit::none ? plain(value) : amount(value, largest);
  if (!requirement.kept && number == amount(limit, largest)) number = unlike_limit(value, limit);
  return with_unit(number, unit, units);
}

std::string requirement_in_words(const Requirement& requirement) {
  const std::string value =
      !requirement.value                    ? "no value"
      : is_yes_or_no(requirement.condition) ? (*requirement.value == 1 ? "yes" : "no")
      : std::isinf(*requirement.value)      ? "no limit"
      : requirement.kept                    ? significant(*requirement.value, 6)
                         : unlike_limit(*requirement.value, requirement.condition.limit);
  return requirement.condition.text + ": " + value + (requirement.kept ? ", kept" : ", not kept");
}

}  // namespace evenlift
