#include "evenlift/output/carrying_words.h"

#include <algorithm>

#include "evenlift/angles.h"
#include "evenlift/capacity.h"
#include "evenlift/tolerance.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

std::string acceleration_in_words(double acceleration) {
  return significant(acceleration, 3) + "\u00A0g";
}

std::string length_in_words(double length, const Units& units) {
  return with_length_unit(plain(length), units);
}

// "With C off by up to 20 mm, on a slope of 8 % and braked at 0.3 g it tips."
std::string tips_under_these(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  std::string text;
  if (shown.com_radius > 0)
    text = "With C off by up to " + length_in_words(shown.com_radius, shown.units) + ", on";
  else
    text = "On";
  text += carrying.slope > 0 ? " a slope of " + slope_in_words(carrying.slope)
                             : std::string(" level ground");
  if (carrying.acceleration > 0)
    text += (carrying.slope > 0 ? " and braked at " : ", braked at ") +
            acceleration_in_words(carrying.acceleration) + ",";
  return text + " it tips.";
}

// A condition that changes loads, as an addition to a sentence and as a clause, each followed by how
// great it is.
struct Condition {
  std::string as_addition, as_clause, amount;
};

// The conditions that change loads.
std::vector<Condition> conditions_of(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  std::vector<Condition> conditions;
  if (shown.com_radius > 0)
    conditions.push_back({"with a C uncertainty of ", "C is off by up to ",
                          length_in_words(shown.com_radius, shown.units)});
  if (carrying.slope > 0)
    conditions.push_back(
        {"on slopes up to ", "the ground slopes by up to ", slope_in_words(carrying.slope)});
  if (carrying.acceleration > 0 && carrying.com_height > 0)
    conditions.push_back({"braked at up to ", "the object is braked at up to ",
                          acceleration_in_words(carrying.acceleration)});
  if (carrying.uneven > 0 && carrying.give)
    conditions.push_back({"with heights off by up to ", "heights are off by up to ",
                          length_in_words(carrying.uneven, shown.units)});
  return conditions;
}

// Whether the point is in the convex region, within tolerance (tau L).
bool is_within(const Points& region, const Vec2& at, double diameter) {
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Vec2 &a = region[i], along = region[(i + 1) % region.size()] - a;
    if (cross(along, at - a) < -near_distance(diameter) * length(along)) return false;
  }
  return !region.empty();
}

}  // namespace

std::string slope_in_words(double ratio) { return significant(100 * ratio, 3) + "\u00A0%"; }

std::string degrees_in_words(double degrees) { return significant(degrees, 3) + "°"; }

std::string disturbance_in_words(const Shown& shown) {
  std::string text;
  for (const Condition& condition : conditions_of(shown))
    text += (text.empty() ? "" : ", ") + (condition.as_addition + condition.amount);
  return text;
}

std::string disturbance_as_clause(const Shown& shown) {
  const std::vector<Condition> conditions = conditions_of(shown);
  std::string text;
  for (std::size_t i = 0; i < conditions.size(); ++i)
    text += (i == 0                      ? ""
             : i + 1 < conditions.size() ? ", "
                                         : " and ") +
            (conditions[i].as_clause + conditions[i].amount);
  return text;
}

std::string without_effect_in_words(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  std::string text;
  if (carrying.acceleration > 0 && !(carrying.com_height > 0))
    text = "The acceleration changes nothing without the height of the centre of mass.";
  if (carrying.uneven > 0 && !carrying.give)
    text += std::string(text.empty() ? "" : " ") +
            "Uneven heights change nothing unless it is known how far robots give way.";
  return text;
}

std::string tipping_in_words(const Robustness& robustness, const ShownPlacement& of) {
  const Shown& shown = of.shown;
  const double reach = disturbance_of(shown).reach, distance = robustness.tipping_distance;
  if (reach > shown.com_radius)
    return is_within_base(reach, distance, of.placement.polygon().diameter())
               ? std::string()
               : tips_under_these(shown);
  if (!(reach > 0) || reach < distance) return {};
  return "It can tip: the centre of mass may be off by " + length_in_words(reach, shown.units) +
         ", and " + with_length_unit(amount(distance, distance), shown.units) +
         " in one direction is enough.";
}

std::string tilt_in_words(const Robustness& robustness, const ShownPlacement& of) {
  const auto tilt =
      tilt_of(of.shown, robustness.tipping_distance, of.placement.polygon().diameter());
  if (!tilt) return {};
  if (!(tilt->slope > 0)) return "On any slope, and whenever it is braked, it can tip.";
  const std::string with_disturbance =
      of.shown.com_radius > 0
          ? ", with C off by up to " + length_in_words(of.shown.com_radius, of.shown.units)
          : std::string();
  return "In the worst direction it tips at a slope of " + degrees_in_words(tilt->degrees) + " (" +
         slope_in_words(tilt->slope) + ") or when it is braked at " +
         acceleration_in_words(tilt->acceleration) + with_disturbance + ".";
}

std::string extra_in_words(const ExtraLoad& extra, const ShownPlacement& of) {
  const Units& units = of.shown.units;
  const std::string load = "Another " + given_weight(extra.weight, units) + " may stand ";
  const char* harm =
      has_capacities(of) ? "lifting a robot off or overloading one" : "lifting a robot off";
  const std::string condition = ", if all robots are equally stiff";
  std::string text;
  if (extra.share >= 1 - tau)
    return load + "anywhere on the object without " + harm + condition + ".";
  if (extra.share <= tau)
    text = load + "nowhere on the object without " + harm + condition + ".";
  else
    text =
        load + "on " + percentage(extra.share) + " of the object without " + harm + condition + ".";
  if (extra.anywhere && *extra.anywhere > 0)
    text += " Up to " + load_in_words(*extra.anywhere, *extra.anywhere, units) +
            " may stand anywhere on it.";
  return text;
}

LoadHere extra_here_in_words(const ExtraLoad& extra, const Vec2& at, const ShownPlacement& of) {
  const std::string here = given_weight(extra.weight, of.shown.units) + " here";
  const auto loads = loads_with(of.placement, extra.weight, at);
  if (!loads) return {here + " tips it", false};
  const auto [least, greatest] = std::minmax_element(loads->begin(), loads->end());
  std::string words =
      here + ": robots carry " + load_in_words(*least, *greatest, *greatest, of.shown.units);
  const std::vector<std::size_t> overloaded = overloaded_robots(of, *loads);
  std::vector<std::size_t> idle;
  for (std::size_t i = 0; i < loads->size(); ++i)
    if (!((*loads)[i] > 0)) idle.push_back(i);
  if (!overloaded.empty())
    words += std::string(" · overloaded: ") + (overloaded.size() == 1 ? "robot " : "robots ") +
             numbers_from_1(overloaded);
  if (!idle.empty())
    words += (idle.size() == 1 ? " · robot " : " · robots ") + numbers_from_1(idle) +
             (idle.size() == 1 ? " goes slack" : " go slack");
  const bool is_fine = is_within(extra.region, at, of.placement.polygon().diameter());
  if (!is_fine && overloaded.empty() && idle.empty()) words += " · not under all given conditions";
  return {words, is_fine};
}

std::string tilt_towards_in_words(const Vec2& at, const ShownPlacement& of) {
  const Placement& placement = of.placement;
  const Vec2 towards = at - placement.centre_of_mass;
  if (!(of.shown.carrying.com_height > 0) || placement.lifting_base.size() < 3 ||
      !placement.loads || !(length(towards) > 0))
    return {};
  const double slope =
      tipping_slope(placement.lifting_base, placement.centre_of_mass, towards, of.shown);
  return "Downhill this way it tips at " + degrees_in_words(slope_degrees(slope)) + " (" +
         slope_in_words(slope) + ")";
}

}  // namespace evenlift
