#include "evenlift/output/requirements.h"

#include "document/stand_settings.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

struct Named {
  std::string_view name;
  Quantity quantity;
};
constexpr Named yes_or_no[] = {
    {"held", Quantity::held}, {"stands", Quantity::stands}, {"steady", Quantity::steady}};
constexpr Named numbers[] = {{"coverage", Quantity::coverage}, {"max", Quantity::max},
                             {"min", Quantity::min},           {"spread", Quantity::spread},
                             {"margin", Quantity::margin},     {"robots", Quantity::robots}};

constexpr const char* allowed =
    "a condition must be held, stands or steady, or one of coverage, max, min, spread, margin and "
    "robots with >= or <= and a number, such as coverage>=0.8";

template <std::size_t count>
std::optional<Quantity> find(const Named (&all)[count], std::string_view name) {
  for (const Named& each : all)
    if (each.name == name) return each.quantity;
  return std::nullopt;
}

std::optional<Condition> read_condition(const std::string& text) {
  if (const auto quantity = find(yes_or_no, text)) return Condition{*quantity, true, 0, text};
  const std::size_t sign = text.find_first_of("<>");
  if (sign == std::string::npos || text.substr(sign + 1, 1) != "=") return std::nullopt;
  const auto quantity = find(numbers, std::string_view(text).substr(0, sign));
  const auto limit = read_number(std::string_view(text).substr(sign + 2));
  if (!quantity || !limit) return std::nullopt;
  return Condition{*quantity, text[sign] == '>', *limit, text};
}

std::string without_spaces(std::string_view text) {
  std::string kept;
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') kept += c;
  return kept;
}

InputError refused(const std::string& condition) {
  const bool quotable = !condition.empty() && is_quotable(condition);
  return bad_setting("require",
                     allowed + (quotable ? ", not \"" + condition + "\"" : std::string()));
}

// What rounding may change in a value.
double slack(Quantity quantity, double weight) {
  switch (quantity) {
    case Quantity::max:
    case Quantity::min:
    case Quantity::spread:
      return tau * weight;
    case Quantity::coverage:
    case Quantity::margin:
      return tau;
    case Quantity::held:
    case Quantity::stands:
    case Quantity::steady:
    case Quantity::robots:
      break;
  }
  return 0;
}

std::optional<double> value_of(Quantity quantity, const Placement& placement) {
  const auto& loads = placement.loads;
  switch (quantity) {
    case Quantity::held:
      return !placement.teams.empty() && is_held(placement) ? 1 : 0;
    case Quantity::stands:
      return loads ? 1 : 0;
    case Quantity::steady:
      return !placement.teams.empty() && robustness(placement).failures_clear >= 1 ? 1 : 0;
    case Quantity::coverage:
      return placement.coverage;
    case Quantity::max:
      return loads ? std::optional(loads->max) : std::nullopt;
    case Quantity::min:
      return loads ? std::optional(loads->min) : std::nullopt;
    case Quantity::spread:
      return loads ? std::optional(loads->spread) : std::nullopt;
    case Quantity::margin:
      return placement.closure.margin;
    case Quantity::robots:
      return static_cast<double>(count_robots(placement.teams));
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<Condition>> read_conditions(std::string_view text) {
  std::vector<Condition> conditions;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string word = without_spaces(text.substr(0, comma));
    const auto condition = read_condition(word);
    if (!condition || conditions.size() == most_conditions) return refused(word);
    conditions.push_back(*condition);
    if (comma == std::string_view::npos) return conditions;
    text.remove_prefix(comma + 1);
  }
}

bool is_yes_or_no(Quantity quantity) {
  for (const Named& each : yes_or_no)
    if (each.quantity == quantity) return true;
  return false;
}

std::vector<Requirement> check_conditions(const Placement& placement,
                                          const std::vector<Condition>& conditions) {
  std::vector<Requirement> requirements;
  for (const Condition& condition : conditions) {
    Requirement requirement{condition, value_of(condition.quantity, placement), false};
    if (is_yes_or_no(condition.quantity))
      requirement.kept = requirement.value == 1;
    else if (requirement.value)
      requirement.kept = (condition.at_least ? *requirement.value - condition.limit
                                             : condition.limit - *requirement.value) >=
                         -slack(condition.quantity, placement.settings.weight);
    requirements.push_back(std::move(requirement));
  }
  return requirements;
}

std::string requirement_in_words(const Requirement& requirement) {
  const std::string value = !requirement.value ? "no value"
                            : is_yes_or_no(requirement.condition.quantity)
                                ? (*requirement.value == 1 ? "yes" : "no")
                                : significant(*requirement.value, 6);
  return requirement.condition.text + ": " + value + (requirement.kept ? ", kept" : ", not kept");
}

}  // namespace evenlift
