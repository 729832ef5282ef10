#include "evenlift/output/carrying_words.h"

#include <algorithm>

#include "evenlift/angles.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "output/words/listed.h"

namespace evenlift {
namespace {

std::string acceleration_in_words(double acceleration, Toward toward = Toward::nearest) {
  return significant(acceleration, 3, toward) + "\u00A0g";
}

// A condition in three forms: "on slopes up to 8 %", "the ground slopes by up to 8 %" and "on a slope
// of 8 %".
struct Circumstance {
  std::string as_addition, as_clause, as_place;
};

// Only those that change loads or tip the object.
std::vector<Circumstance> conditions_of(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  std::vector<Circumstance> conditions;
  const auto add = [&](const char* addition, const char* clause, const char* place,
                       const std::string& size) {
    conditions.push_back({say(addition, {size}), say(clause, {size}), say(place, {size})});
  };
  if (shown.com_radius > 0)
    add("with a C uncertainty of {amount}", "C is off by up to {amount}",
        "with C off by up to {amount}", given_length(shown.com_radius, shown.units));
  if (carrying.slope > 0)
    add("on slopes up to {amount}", "the ground slopes by up to {amount}", "on a slope of {amount}",
        slope_in_words(carrying.slope));
  if (carrying.acceleration > 0 && carrying.has_height())
    add("braked at up to {amount}", "the object is braked at up to {amount}",
        carrying.slope > 0 ? "braked at {amount}" : "braked at {amount} on level ground",
        acceleration_in_words(carrying.acceleration));
  if (carrying.uneven > 0)
    add("with heights off by up to {amount}", "heights are off by up to {amount}",
        "with heights off by up to {amount}", given_length(carrying.uneven, shown.units));
  return conditions;
}

// Within tolerance (tau L); the region is convex.
bool is_within(const Points& region, const Vec2& at, double diameter) {
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Vec2 &a = region[i], along = region[(i + 1) % region.size()] - a;
    if (cross(along, at - a) < -near_distance(diameter) * length(along)) return false;
  }
  return !region.empty();
}

}  // namespace

std::string given_length(double length, const Units& units) {
  constexpr std::size_t most_given = 8;
  const std::string text = plain(length);
  if (text.size() > most_given) return length_in_words(length, units, Toward::up);
  return with_length_unit(text, units);
}

std::string slope_in_words(double ratio, Toward toward) {
  return significant(100 * ratio, 3, toward) + "\u00A0%";
}

std::string degrees_in_words(double degrees) { return significant(degrees, 3, Toward::down) + "°"; }

std::string disturbance_in_words(const Shown& shown) {
  std::string text;
  for (const Circumstance& condition : conditions_of(shown))
    text += (text.empty() ? "" : ", ") + condition.as_addition;
  return text;
}

std::string disturbance_as_clause(const Shown& shown) {
  const std::vector<Circumstance> conditions = conditions_of(shown);
  std::string text;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const std::string& clause = conditions[i].as_clause;
    text = i == 0                      ? clause
           : i + 1 < conditions.size() ? text + ", " + clause
                                       : say("{clauses} and {last}", {text, clause});
  }
  return text;
}

std::string conditions_in_words(const Shown& shown) {
  std::string text;
  for (const Circumstance& condition : conditions_of(shown))
    text += (text.empty() ? "" : ", ") + condition.as_place;
  return text;
}

std::string given_in_part_in_words(const Reported& of) {
  const Carrying& carrying = of.shown.carrying;
  std::string text;
  const auto add = [&](const std::string& sentence) {
    text += (text.empty() ? "" : " ") + sentence;
  };
  if (carrying.slope > 0 && !carrying.has_height())
    add(
        say("Without the height of the centre of mass, a slope counts only because less of the "
            "weight acts across it: whether the object tips on it is not known."));
  if (carrying.acceleration > 0 && !carrying.has_height())
    add(say("The acceleration changes nothing without the height of the centre of mass."));
  if (carrying.uneven > 0 && !carrying.give && !of.report.loads_are_determined) {
    const auto& worst = of.report.worst;
    if (worst && !worst->empty() && !of.report.tips)
      add(say("Without the give of the robots, the loads can reach those at worst, up to {load}.",
              {load_in_words(*std::max_element(worst->begin(), worst->end()), of.shown.units,
                             Toward::up)}));
  }
  return text;
}

std::string tipping_in_words(const Reported& of) {
  const Shown& shown = of.shown;
  const double reach = of.report.effect.reach, distance = of.report.robustness.tipping_distance;
  if (reach > shown.com_radius) {
    if (!of.report.tips) return {};
    const std::string conditions = conditions_in_words(shown);
    return with_capital(
        say(conditions_of(shown).size() == 1 ? "{conditions} it tips." : "{conditions}, it tips.",
            {conditions}));
  }
  if (!(reach > 0) || reach < distance) return {};
  return say(
      "It can tip: the centre of mass may be off by {reach}, and {distance} in one direction is "
      "enough.",
      {given_length(reach, shown.units), length_in_words(distance, shown.units, Toward::up)});
}

std::string tilt_in_words(const Reported& of) {
  const std::optional<Tilt>& tilt = of.report.tilt;
  if (!tilt) return {};
  if (!(tilt->slope > 0)) return say("On any slope, and whenever it is braked, it can tip.");
  const std::string degrees = degrees_in_words(tilt->degrees),
                    slope = slope_in_words(tilt->slope, Toward::down),
                    acceleration = acceleration_in_words(tilt->acceleration, Toward::down);
  std::string text =
      of.shown.com_radius > 0
          ? say("In the worst direction it tips at a slope of {degrees} ({slope}) or, on level "
                "ground, when it is braked at {acceleration}, with C off by up to {radius}.",
                {degrees, slope, acceleration, given_length(of.shown.com_radius, of.shown.units)})
          : say("In the worst direction it tips at a slope of {degrees} ({slope}) or, on level "
                "ground, when it is braked at {acceleration}.",
                {degrees, slope, acceleration});
  // What is left with a slope or an acceleration allows for uneven heights; the above does not.
  if (const double tilted = of.report.effect.tilt; tilted > 0)
    text += " " + say("With heights off by up to {amount}, it tips at a slope of {slope}.",
                      {given_length(of.shown.carrying.uneven, of.shown.units),
                       slope_in_words(std::max(0.0, tilt->slope - tilted), Toward::down)});
  if (tilt->stays && tilt->acceleration_left)
    text += " " + say("On the slope of {slope} it tips when it is braked at {acceleration}.",
                      {slope_in_words(of.shown.carrying.slope),
                       acceleration_in_words(*tilt->acceleration_left, Toward::down)});
  if (tilt->stays && tilt->slope_left)
    text += " " + say("Braked at {acceleration}, it tips at a slope of {slope}.",
                      {acceleration_in_words(of.shown.carrying.acceleration),
                       slope_in_words(*tilt->slope_left, Toward::down)});
  return text;
}

std::string extra_in_words(const Reported& of) {
  if (!of.report.extra) return {};
  const ExtraLoad& extra = *of.report.extra;
  constexpr const char* sentences[3][2] = {
      {"Another {weight} may stand anywhere on the object without lifting a robot off, if all robots are equally stiff and level and the object does not bend.",
       "Another {weight} may stand anywhere on the object without lifting a robot off or overloading "
       "one, if all robots are equally stiff and level and the object does not bend."},
      {"Another {weight} may stand nowhere on the object without lifting a robot off, if all robots are equally stiff and level and the object does not bend.",
       "Another {weight} may stand nowhere on the object without lifting a robot off or overloading "
       "one, if all robots are equally stiff and level and the object does not bend."},
      {"Another {weight} may stand on {share} of the object without lifting a robot off, if all "
       "robots are equally stiff and level and the object does not bend.",
       "Another {weight} may stand on {share} of the object without lifting a robot off or "
       "overloading one, if all robots are equally stiff and level and the object does not bend."}};
  const Units& units = of.shown.units;
  const std::size_t where = extra.share >= 1 - tau ? 0 : extra.share <= tau ? 1 : 2;
  const std::string values[] = {given_weight(extra.weight, units), percentage(extra.share)};
  std::string text =
      say_written(sentences[where][of.report.has_capacities ? 1 : 0], values, where == 2 ? 2 : 1);
  if (where != 0 && extra.anywhere && *extra.anywhere > 0)
    text += " " + say("Up to {load} may stand anywhere on it.",
                      {load_in_words(*extra.anywhere, units, Toward::down)});
  return text;
}

LoadHere extra_here_in_words(const ExtraLoad& extra, const Vec2& at, const ShownPlacement& of) {
  const std::string weight = given_weight(extra.weight, of.shown.units);
  const auto loads = loads_with(of.placement, extra.weight, at);
  if (!loads) return {say("{weight} here tips it", {weight}), false};
  const auto [least, greatest] = std::minmax_element(loads->begin(), loads->end());
  std::string words = say("{weight} here: robots carry {loads}",
                          {weight, load_in_words(*least, *greatest, *greatest, of.shown.units)});
  const std::vector<std::size_t> overloaded = overloaded_robots(of, *loads);
  std::vector<std::size_t> idle;
  for (std::size_t i = 0; i < loads->size(); ++i)
    if (!((*loads)[i] > 0)) idle.push_back(i);
  if (!overloaded.empty())
    words += " · " + say(overloaded.size() == 1 ? "overloaded: robot {robots}"
                                                : "overloaded: robots {robots}",
                         {numbers_of(of.placement, overloaded)});
  if (!idle.empty())
    words +=
        " · " + say(idle.size() == 1 ? "robot {robots} goes slack" : "robots {robots} go slack",
                    {numbers_of(of.placement, idle)});
  const bool is_fine = is_within(extra.region, at, of.placement.polygon().diameter());
  if (!is_fine && overloaded.empty() && idle.empty())
    words += " · " + say("not under all given conditions");
  return {words, is_fine};
}

std::string tilt_towards_in_words(const Vec2& at, const ShownPlacement& of) {
  const Placement& placement = of.placement;
  const Vec2 towards = at - placement.centre_of_mass;
  if (!of.shown.carrying.has_height() || placement.lifting_base.size() < 3 || !placement.loads ||
      !(length(towards) > 0))
    return {};
  const double slope =
      tipping_slope(placement.lifting_base, placement.centre_of_mass, towards, of.shown);
  return say("Downhill this way it tips at {degrees} ({slope})",
             {degrees_in_words(slope_degrees(slope)), slope_in_words(slope, Toward::down)});
}

}  // namespace evenlift
