#include "evenlift/output/verdict.h"

#include <algorithm>
#include <cmath>

#include "document/setting_values.h"
#include "evenlift/numbers.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/quantities.h"
#include "evenlift/output/requirements.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/words.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

std::string misfit_sentence(const ShownPlacement& of, const Misfit& misfit) {
  const RobotSize& size = of.placement.settings.robot;
  const std::string robot = of.placement.called(misfit.robot);
  switch (misfit.why) {
    case Misfit::Why::outside:
      return size.radius > 0 ? say("Robot {robot} has no room for its body of radius {radius}.",
                                   {robot, with_length_unit(plain(size.radius), of.shown.units)})
                             : say("Robot {robot} has no room for its body.", {robot});
    case Misfit::Why::arm:
      return say("The arm of robot {robot} would cross the object.", {robot});
    case Misfit::Why::hand:
      return say("The hand of robot {robot} would stick out of the object.", {robot});
    case Misfit::Why::hole:
      return say("The hand of robot {robot} would reach into a hole.", {robot});
    case Misfit::Why::no_go:
      return say("Robot {robot} stands at a no-go part of the boundary.", {robot});
    case Misfit::Why::too_near:
      break;
  }
  return say("Robots {other} and {robot} are too near to each other.",
             {of.placement.called(misfit.other), robot});
}

}  // namespace

std::string_view name(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::good:
      return "good";
    case VerdictKind::warning:
      return "warning";
    case VerdictKind::bad:
      return "bad";
  }
  return {};
}

std::vector<std::string> misfits_in_words(const Reported& of) {
  constexpr std::size_t most_listed = 3;
  const std::vector<Misfit>& all = of.report.misfits;
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < all.size() && i < most_listed; ++i)
    sentences.push_back(misfit_sentence(of, all[i]));
  if (all.size() > most_listed)
    sentences.push_back(
        say("The robots do not fit in {number} more ways.", {all.size() - most_listed}));
  return sentences;
}

namespace {

// "Robots 3 and 5 are outside the object: they carry nothing."
std::string left_out_sentence(const Placement& placement, const Misplaced& first) {
  const bool is_hole = first.kind == Misplaced::Kind::hole;
  std::vector<std::string> numbers;
  for (const Misplaced& each : placement.left_out)
    if (each.kind == first.kind && each.in_hole == first.in_hole)
      numbers.push_back(is_hole ? std::to_string(each.index + std::size_t{1})
                                : support_called(placement.settings, each.index));
  const bool one = numbers.size() == 1;
  const std::string named = listed_briefly(numbers);
  if (is_hole)
    return say(one ? "Hole {holes} does not fit the object, and is left out."
                   : "Holes {holes} do not fit the object, and are left out.",
               {named});
  if (!first.in_hole)
    return say(one ? "Robot {robots} is outside the object: it carries nothing."
                   : "Robots {robots} are outside the object: they carry nothing.",
               {named});
  return say(one ? "Robot {robots} is in hole {hole}: it carries nothing."
                 : "Robots {robots} are in hole {hole}: they carry nothing.",
             {named, *first.in_hole + 1});
}

}  // namespace

std::vector<std::string> left_out_in_words(const Placement& placement) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < placement.left_out.size(); ++i) {
    const Misplaced& each = placement.left_out[i];
    const auto is_told = [&](const Misplaced& other) {
      return other.kind == each.kind && other.in_hole == each.in_hole;
    };
    if (std::none_of(placement.left_out.begin(),
                     placement.left_out.begin() + static_cast<std::ptrdiff_t>(i), is_told))
      sentences.push_back(left_out_sentence(placement, each));
  }
  return sentences;
}

Judgement judge(const Reported& of) {
  const Placement& placement = of.placement;
  Judgement judgement;
  std::vector<std::string>& reasons = judgement.reasons;
  const auto add = [&](std::string_view code, std::string reason) {
    if (reason.empty()) return;
    reasons.push_back(std::move(reason));
    judgement.codes.push_back(code);
  };
  const auto add_left_out = [&] {
    for (std::string& sentence : left_out_in_words(placement)) add("left_out", std::move(sentence));
  };
  if (placement.teams.empty()) {
    judgement.kind = VerdictKind::bad;
    add_left_out();
    if (placement.left_out.empty() || placement.settings.method != Method::given)
      add("no_place", placement.search_ended ? shortage_in_words(placement) : loads_in_words(of));
    return judgement;
  }
  const bool stands = placement.loads.has_value();
  if (!stands) add("falls", loads_in_words(of));
  if (stands) add(of.report.tips ? "tips" : "overloaded", worst_news_in_words(of));
  const bool is_bad = !reasons.empty();
  add_left_out();
  for (std::string& misfit : misfits_in_words(of)) add("misfit", std::move(misfit));
  add("fewer_teams", shortage_in_words(placement));
  add("not_upright", upright_in_words(of));
  if (placement.coverage < good_coverage && !of.report.tips)
    add("low_coverage", coverage_in_words(placement));
  if (!of.report.held) add("not_held", closure_in_words(of));
  add("inaccurate", inaccuracy_in_words(of));
  judgement.kind = is_bad            ? VerdictKind::bad
                   : reasons.empty() ? VerdictKind::good
                                     : VerdictKind::warning;
  return judgement;
}

namespace {

const Quantity* find(std::string_view condition) {
  const auto all = quantities();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Quantity& each) {
    return !condition.empty() && each.condition == condition;
  });
  return found == all.end() ? nullptr : &*found;
}

const Quantity& quantity_of(const Condition& condition) { return *find(condition.quantity); }

bool is_yes_or_no(const Quantity& quantity) { return quantity.unit == Unit::yes_or_no; }

std::string names(bool yes_or_no) {
  std::string found[2];  // all but the last, and the last
  for (const Quantity& quantity : quantities()) {
    if (quantity.condition.empty() || is_yes_or_no(quantity) != yes_or_no) continue;
    if (!found[1].empty()) found[0] += (found[0].empty() ? "" : ", ") + found[1];
    found[1] = quantity.condition;
  }
  return say_written(yes_or_no ? "{names} or {last}" : "{names} and {last}", found, 2);
}

std::optional<Condition> read_condition(const std::string& text) {
  const std::size_t sign = text.find_first_of("<>");
  const std::string_view name = std::string_view(text).substr(0, sign);
  const Quantity* quantity = find(name);
  if (!quantity || is_yes_or_no(*quantity) != (sign == std::string::npos)) return std::nullopt;
  if (is_yes_or_no(*quantity)) return Condition{quantity->condition, true, 0, text};
  if (text.substr(sign + 1, 1) != "=") return std::nullopt;
  const auto limit = read_number(std::string_view(text).substr(sign + 2));
  if (!limit) return std::nullopt;
  return Condition{quantity->condition, text[sign] == '>', *limit, text};
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
    case Unit::yes_or_no:
    case Unit::count:
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

bool is_yes_or_no(const Condition& condition) { return is_yes_or_no(quantity_of(condition)); }

bool need_failures(const std::vector<Condition>& conditions) {
  return std::any_of(conditions.begin(), conditions.end(), [](const Condition& condition) {
    return quantity_of(condition).needs_failures;
  });
}

std::vector<Requirement> check_conditions(const Reported& of,
                                          const std::vector<Condition>& conditions) {
  if (need_failures(conditions) && !of.report.known.failures) {
    Report report = of.report;
    complete(report, of, {.model = report.known.model, .failures = true});
    return check_conditions({of, report}, conditions);
  }
  std::vector<Requirement> requirements;
  for (const Condition& condition : conditions) {
    const Quantity& quantity = quantity_of(condition);
    Requirement requirement{condition, quantity.value(of), false};
    if (is_yes_or_no(quantity))
      requirement.kept = requirement.value == 1;
    else if (requirement.value)
      requirement.kept = (condition.at_least ? *requirement.value - condition.limit
                                             : condition.limit - *requirement.value) >=
                         -slack(quantity.unit, of.placement);
    requirements.push_back(std::move(requirement));
  }
  return requirements;
}

std::string condition_in_words(const Condition& condition, const Units& units) {
  const Quantity& quantity = quantity_of(condition);
  if (is_yes_or_no(quantity)) return say(quantity.subject);
  return say(
      condition.at_least ? "{quantity} is at least {limit}" : "{quantity} is at most {limit}",
      {quantity.subject,
       with_unit(plain(in_unit(condition.limit, quantity.unit)), quantity.unit, units)});
}

std::string value_in_words(const Requirement& requirement, const Units& units) {
  if (!requirement.value) return {};
  if (is_yes_or_no(requirement.condition)) return *requirement.value == 1 ? "yes" : "no";
  if (std::isinf(*requirement.value)) return say("no limit");
  const Unit unit = quantity_of(requirement.condition).unit;
  const double value = in_unit(*requirement.value, unit);
  const double limit = in_unit(requirement.condition.limit, unit);
  const double largest = std::max(std::abs(value), std::abs(limit));
  std::string number = unit == Unit::count ? plain(value) : amount(value, largest);
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
