#include "evenlift/output/quantities.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/output/carrying_words.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

using Known = std::optional<double>;

bool has_robots(const Reported& of) { return !of.placement.teams.empty(); }
bool in_pairs(const Reported& of) { return !is_one_team(of.placement.settings.method); }
bool stands(const Reported& of) { return of.placement.loads.has_value(); }
// Whether robots carry it under all given conditions.
bool is_carried(const Reported& of) { return stands(of) && !of.report.tips; }

Known extreme(const std::vector<LoadRange>& loads, bool greatest) {
  if (loads.empty()) return std::nullopt;
  double found = greatest ? loads.front().greatest : loads.front().least;
  for (const LoadRange& load : loads)
    found = greatest ? std::max(found, load.greatest) : std::min(found, load.least);
  return found;
}

template <double LoadSummary::*member>
Known load(const Reported& of) {
  return stands(of) ? Known((*of.placement.loads).*member) : std::nullopt;
}

template <int Robustness::*member>
Known failures(const Reported& of) {
  return of.report.robustness.*member;
}

template <Promise promise>
Known promised(const Reported& of) {
  return of.report.accuracy[promise];
}

// Whether any one robot may fail, on level ground and under the given conditions.
Known steady(const Reported& of) {
  if (!has_robots(of) || of.report.robustness.failures_clear < 1) return false;
  if (!of.report.disturbance.any()) return true;
  return std::all_of(of.report.failures.begin(), of.report.failures.end(),
                     [](const auto& rest) { return rest && rest->stays; });
}

Known greatest_after_failure(const Reported& of) {
  if (!stands(of)) return std::nullopt;
  double greatest = 0;
  for (const auto& rest : of.report.failures) {
    if (!rest || !rest->greatest_end) return std::nullopt;
    greatest = std::max(greatest, *rest->greatest_end);
  }
  return greatest;
}

Known worst_load(const Reported& of) {
  const auto& loads = of.report.worst;
  if (of.report.tips || !loads || loads->empty()) return std::nullopt;
  return *std::max_element(loads->begin(), loads->end());
}

Known greatest_use(const Reported& of) {
  const auto most = of.report.most_used();
  return is_carried(of) && most ? of.report.use[*most] : std::nullopt;
}

// How many times as far C may move before the object tips as the given conditions move it. Robots
// that are off their places move the lifting base.
Known safety(const Reported& of) {
  const double reach = of.report.effect.reach, off = of.placement.settings.accuracy.value_or(0);
  if (!stands(of) || !(reach > 0)) return std::nullopt;
  return std::max(0.0, of.report.robustness.tipping_distance - off) / reach;
}

// --- Facts

// A margin below 0 measures how far form closure is missed, not a strength.
std::string hold_words(const Reported& of) {
  const Closure& closure = of.placement.closure;
  if (closure.form_closure && closure.margin) return margin_in_words(*closure.margin);
  return closure.second_order ? "by curvature alone" : "not held";
}

// Of the promise that ends first.
template <Promise promise>
std::string accuracy_words(const Reported& of) {
  const auto& first = of.report.accuracy.first;
  if (!first || first->what != promise ||
      !(first->within > near_distance(of.placement.polygon().diameter())))
    return {};
  return promised_length(first->within, of.shown.units);
}

// The numbers of failures ignore the given conditions.
std::string presuming(const std::string& may_fail, const Reported& of) {
  const bool level = of.report.disturbance.besides_com(), exact = of.shown.com_radius > 0;
  return level && exact ? say("{failures}, on level ground and with C as given", {may_fail})
         : level        ? say("{failures}, on level ground", {may_fail})
         : exact        ? say("{failures}, with C as given", {may_fail})
                        : may_fail;
}

std::string failures_words(const Reported& of) {
  if (of.report.failed) return say("one fails now");
  if (!stands(of)) return {};
  // Barely steady does not count.
  const auto number = [](int failures) { return static_cast<std::size_t>(std::max(failures, 0)); };
  const std::size_t carried = number(of.report.robustness.failures_carried),
                    steady = number(of.report.robustness.failures_clear);
  if (carried == 0) return say("none");
  return presuming(steady >= carried ? say("any {number}", {carried})
                   : steady == 0
                       ? say("any {number}, but it can tip then", {carried})
                       : say("any {steady}; any {carried} if it may tip", {steady, carried}),
                   of);
}

std::string tipping_distance_words(const Reported& of) {
  if (!stands(of) && !of.report.failed) return {};
  return length_in_words(of.report.robustness.tipping_distance, of.shown.units, Toward::down);
}

std::string tipping_slope_words(const Reported& of) {
  const auto& tilt = of.report.tilt;
  if (!tilt || (!stands(of) && !of.report.failed)) return {};
  return degrees_in_words(tilt->degrees) + " (" + slope_in_words(tilt->slope, Toward::down) + ")";
}

constexpr char may_be_off[] = "Robots may be off by";

// clang-format off
const Quantity rows[] = {
    {.label = "Candidate teams", .about = "One for each candidate chord at this minimum load ratio; two robots each",
     .in_words = [](const Reported& of) { return in_pairs(of) ? std::to_string(of.placement.candidates.size()) : std::string(); }},

    {.value = [](const Reported& of) -> Known { return static_cast<double>(count_robots(of.placement.teams) - (of.report.failed ? 1 : 0)); },
     .unit = Unit::count, .condition = "robots", .subject = "The number of robots", .compared = "Robots"},

    // Loads as shown, for a table of all shapes.
    {.value = [](const Reported& of) { return extreme(of.report.loads, true); }, .unit = Unit::weight, .better = Better::less, .column = "greatest load"},
    {.value = [](const Reported& of) { return extreme(of.report.loads, false); }, .unit = Unit::weight, .better = Better::more, .column = "least load"},

    {.value = [](const Reported& of) -> Known { return of.placement.coverage; }, .unit = Unit::share, .better = Better::more,
     .condition = "coverage", .subject = "The coverage", .json = "coverage", .label = "Coverage", .column = "coverage", .compared = "Coverage",
     .about = "Share of the object above the lifting base: pressing down there does not tip it, if robots "
              "push back and none is overloaded",
     .in_words = [](const Reported& of) { return has_robots(of) ? percentage(of.placement.coverage, 1) : std::string(); }},

    // As planned, under the given conditions.
    {.value = [](const Reported& of) { return is_carried(of) ? extreme(of.report.planned, true) : std::nullopt; }, .unit = Unit::weight, .better = Better::less, .rounded = Toward::up,
     .condition = "max", .subject = "The greatest load"},
    {.value = [](const Reported& of) { return is_carried(of) ? extreme(of.report.planned, false) : std::nullopt; }, .unit = Unit::weight, .better = Better::more,
     .condition = "min", .subject = "The least load"},

    // As planned, without them.
    {.value = load<&LoadSummary::min>, .unit = Unit::weight, .better = Better::more, .json = "loads.min", .compared = "Least load, {unit}"},
    {.value = load<&LoadSummary::mean>, .unit = Unit::weight, .json = "loads.mean",
     .label = "Mean load", .about = "Of all robots" },
    {.value = load<&LoadSummary::max>, .unit = Unit::weight, .better = Better::less, .json = "loads.max", .compared = "Greatest load, {unit}"},
    {.value = load<&LoadSummary::spread>, .unit = Unit::weight, .better = Better::less,
     .condition = "spread", .subject = "The greatest load minus the least", .json = "loads.spread",
     .label = "Spread of loads", .compared = "Spread of loads, {unit}", .about = "Greatest load minus least load" },
    {.value = load<&LoadSummary::max_share>, .unit = Unit::share, .better = Better::less, .json = "loads.max_share",
     .label = "Greatest share in a team", .about = "50 % in an even team",
     .in_words = [](const Reported& of) { return in_pairs(of) && stands(of) ? percentage(of.placement.loads->max_share, 1) : std::string(); }},
    {.value = greatest_use, .unit = Unit::share, .better = Better::less, .rounded = Toward::up,
     .condition = "use", .subject = "The greatest load as a part of the robot's capacity", .json = "capacity.use",
     .label = "Greatest use", .column = "use",
     .about = "Of all robots, the greatest load as a part of the capacity; as planned, under the given conditions, times "
              "the dynamic factor and 1 + the uncertainty of the weight",
     .needs_capacities = true},
    {.value = safety, .better = Better::more, .rounded = Toward::down, .condition = "safety",
     .subject = "The safety against tipping"},
    {.value = greatest_after_failure, .unit = Unit::weight, .better = Better::less, .rounded = Toward::up,
     .condition = "max_after_failure", .subject = "The greatest load after any one failure", .needs_failures = true},

    {.value = [](const Reported& of) -> Known { return of.placement.closure.form_closure; }, .unit = Unit::yes_or_no, .better = Better::more,
     .json = "closure.form_closure", .label = "Form closure", .compared = "Form closure",
     .about = "Whether the robots' contact alone keeps the object from moving in the plane, to first "
              "order, if no robot gives way",
     .in_words = [](const Reported& of) { return has_robots(of) ? form_closure_in_words(of.placement.closure) : std::string(); }},
    {.value = [](const Reported& of) { return of.placement.closure.margin; }, .better = Better::more,
     .condition = "margin", .subject = "The margin of form closure", .json = "closure.margin",
     .label = "Margin", .about = "Strength of form closure; compare only placements of the same object",
     .in_words = [](const Reported& of) { return has_robots(of) ? hold_words(of) : std::string(); }},
    {.value = [](const Reported& of) { return Known(of.placement.closure.clearance.distance); }, .unit = Unit::length, .better = Better::more, .json = "closure.clearance"},
    {.value = [](const Reported& of) { return Known(of.placement.closure.clearance.tolerance); }, .unit = Unit::length, .better = Better::more, .json = "closure.tolerance"},
    {.value = [](const Reported& of) -> Known { return of.placement.closure.second_order; }, .unit = Unit::yes_or_no, .better = Better::more, .json = "closure.second_order"},

    {.label = may_be_off, .about = "All at once, each along its edge, except robots in inward corners: what is told remains true. "
                                   "Farther off, a robot may have no room",
     .in_words = accuracy_words<Promise::fits>},
    {.label = may_be_off, .about = "All at once, each along its edge, except robots in inward corners: what is told remains true. "
                                   "Farther off, the object may tip",
     .in_words = accuracy_words<Promise::stands>},
    {.label = may_be_off, .about = "All at once, each along its edge, except robots in inward corners: what is told remains true. "
                                   "Farther off, the robots may no longer hold it",
     .in_words = accuracy_words<Promise::hold>},
    {.label = may_be_off, .about = "All at once, each along its edge, except robots in inward corners: what is told remains true. "
                                   "Farther off, a robot may be overloaded",
     .in_words = accuracy_words<Promise::capacity>},
    {.value = promised<Promise::fits>, .unit = Unit::length, .better = Better::more, .rounded = Toward::down, .json = "accuracy.fits_within"},
    {.value = promised<Promise::stands>, .unit = Unit::length, .better = Better::more, .rounded = Toward::down, .json = "accuracy.stands_within"},
    {.value = promised<Promise::hold>, .unit = Unit::length, .better = Better::more, .rounded = Toward::down, .json = "accuracy.hold_within"},
    {.value = promised<Promise::capacity>, .unit = Unit::length, .better = Better::more, .rounded = Toward::down, .json = "accuracy.capacity_within"},

    {.value = [](const Reported& of) -> Known { return of.report.equilibrium.com_margin; }, .unit = Unit::length, .better = Better::more, .rounded = Toward::down, .json = "robustness.com_margin"},
    {.value = failures<&Robustness::failures_carried>, .unit = Unit::count, .better = Better::more, .json = "robustness.failures_carried",
     .label = "Robots that may fail",
     .about = "If this number of robots fails at once, whichever they are, the others carry the object, if "
              "none is overloaded",
     .in_words = failures_words},
    {.value = failures<&Robustness::failures_steady>, .unit = Unit::count, .better = Better::more, .json = "robustness.failures_steady"},
    {.value = failures<&Robustness::failures_clear>, .unit = Unit::count, .better = Better::more, .json = "robustness.failures_clear"},
    {.value = [](const Reported& of) -> Known { return of.report.robustness.tipping_distance; }, .unit = Unit::length, .better = Better::more, .rounded = Toward::down,
     .condition = "tipping_distance", .subject = "The tipping distance", .label = "Tipping distance",
     .about = "If C is farther off than this, the object can tip; nearer it does not, if robots push back "
              "and none is overloaded",
     .in_words = tipping_distance_words},
    {.value = [](const Reported& of) { return of.report.tilt ? Known(of.report.tilt->degrees) : std::nullopt; }, .unit = Unit::degrees, .better = Better::more, .rounded = Toward::down,
     .condition = "tip", .subject = "The slope at which it tips", .label = "It tips on a slope of",
     .about = "In the worst direction, at rest. On level ground it tips when it is braked at that ratio "
              "in g: 25 % means 0.25 g",
     .in_words = tipping_slope_words},
    {.value = [](const Reported& of) {
       const auto& first = of.report.accuracy.first;
       return is_carried(of) ? Known(first ? first->within : std::numeric_limits<double>::infinity()) : std::nullopt;
     },
     .unit = Unit::length, .better = Better::more, .rounded = Toward::down, .condition = "within", .subject = "How far robots may be off"},
    {.value = worst_load, .unit = Unit::weight, .better = Better::less, .rounded = Toward::up, .condition = "worst", .subject = "The greatest load that statics allows"},

    {.value = [](const Reported& of) -> Known { return of.report.held; }, .unit = Unit::yes_or_no, .better = Better::more,
     .condition = "held", .subject = "The robots hold the object", .json = "held", .column = "held"},
    {.value = [](const Reported& of) -> Known { return stands(of); }, .unit = Unit::yes_or_no, .better = Better::more,
     .condition = "stands", .subject = "The object stands on its robots", .json = "stands"},
    {.value = [](const Reported& of) -> Known { return of.placement.goal_reached; }, .unit = Unit::yes_or_no, .better = Better::more,
     .json = "goal_reached"},
    {.value = steady, .unit = Unit::yes_or_no, .better = Better::more,
     .condition = "steady", .subject = "Any one robot may fail without tipping the object", .needs_failures = true},
    {.value = [](const Reported& of) -> Known { return of.report.upright; }, .unit = Unit::yes_or_no, .better = Better::more,
     .condition = "upright", .subject = "The centre of mass is clearly inside the lifting base"},
    {.value = [](const Reported& of) -> Known { return is_carried(of) && of.report.overloaded_as_planned.empty(); }, .unit = Unit::yes_or_no, .better = Better::more,
     .condition = "capacity", .subject = "No robot carries more than its capacity"},
};
// clang-format on

double largest_load(const Reported& of) { return stands(of) ? of.placement.loads->max : 0; }

// The value with its unit.
std::string told(const Quantity& quantity, const Known& value, const Reported& of) {
  if (!value) return {};
  const std::string text = cell_in_words(quantity, *value, largest_load(of));
  const bool has_unit = quantity.unit == Unit::share || quantity.unit == Unit::degrees;
  return has_unit ? text : with_unit(text, quantity.unit, of.shown.units);
}

// Without the unit of a weight, which the label has.
std::string cell(const Quantity& quantity, const Known& value, const Reported& of) {
  if (quantity.unit != Unit::weight && quantity.in_words) return quantity.in_words(of);
  return value ? cell_in_words(quantity, *value, largest_load(of)) : "–";
}

}  // namespace

std::span<const Quantity> quantities() { return rows; }

std::vector<Fact> facts_in_words(const Reported& of) {
  std::vector<Fact> facts;
  for (const Quantity& quantity : rows) {
    if (!quantity.label) continue;
    std::string value =
        quantity.in_words ? quantity.in_words(of) : told(quantity, quantity.value(of), of);
    if (!value.empty()) facts.push_back({quantity.label, std::move(value), quantity.about});
  }
  return facts;
}

std::vector<Compared> compared_in_words(const Reported& a, const Reported& b) {
  std::vector<Compared> compared;
  const std::string_view unit = name(a.shown.units.weight);
  for (const Quantity& quantity : rows) {
    if (!quantity.compared) continue;
    const Known known[] = {quantity.value(a), quantity.value(b)};
    const bool weighs = quantity.unit == Unit::weight;
    Compared row{weighs ? say(quantity.compared, {unit}) : say(quantity.compared),
                 {cell(quantity, known[0], a), cell(quantity, known[1], b)},
                 {}};
    if (known[0] && known[1] && row.values[0] != row.values[1] &&
        quantity.better != Better::neither)
      row.better = (*known[0] > *known[1]) == (quantity.better == Better::more) ? 0 : 1;
    compared.push_back(std::move(row));
  }
  return compared;
}

std::string cell_in_words(const Quantity& quantity, double value, double largest) {
  switch (quantity.unit) {
    case Unit::yes_or_no:
      return value == 1 ? "yes" : "no";
    case Unit::count:
      return plain(value);
    case Unit::share:
      return quantity.rounded == Toward::nearest
                 ? percentage(value)
                 : significant(100 * value, 3, quantity.rounded) + "\u00A0%";
    case Unit::degrees:
      return degrees_in_words(value);
    case Unit::number:
    case Unit::weight:
    case Unit::length:
      break;
  }
  return amount(value, largest, quantity.rounded);
}

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
    case Unit::yes_or_no:
    case Unit::count:
    case Unit::number:
      break;
  }
  return number;
}

}  // namespace evenlift
