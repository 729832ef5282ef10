#include "evenlift/output/weighing_words.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

constexpr const char* nothing = "\u2013";

std::string length_up(double length, const Units& units) {
  return length_in_words(length, units, Toward::up);
}

std::string height_in_words(const Reported& of, const Weighing::Height& found) {
  const Units& units = of.shown.units;
  const double most = found.height + found.error;
  std::string text =
      most <= 0 ? say("The second weighing puts C below the lifting points.")
      : found.height - found.error < 0
          ? say("C is at most {height} above the lifting points.", {length_up(most, units)})
      : found.error == 0 ? say("C is {height} above the lifting points.",
                               {length_in_words(found.height, units, Toward::nearest)})
                         : say("C is {height} above the lifting points, known within {error}.",
                               {length_in_words(found.height, units, Toward::nearest),
                                length_up(found.error, units)});
  constexpr double enough_deg = 5;
  if (slope_degrees(of.placement.settings.weighed.tilted) < enough_deg &&
      found.error > 0.1 * std::fabs(found.height))
    text += " " + say("Tilt by 5° or more to know it better.");
  if (!found.fits)
    text +=
        " " + say("The readings on the slope add up to another weight, so one of them is wrong.");
  return text;
}

}  // namespace

std::string weighed_in_words(const Reported& of) {
  const auto& weighing = of.placement.weighing;
  if (!weighing) return {};
  const Units& units = of.shown.units;
  const std::string weight = load_in_words(weighing->weight, units, Toward::nearest),
                    at = point_in_words(weighing->centre,
                                        coordinate_decimals(of.placement.vertices()));
  if (!(of.shown.com_radius > 0)) return say("Weighed: {weight}, C at {place}.", {weight, at});
  return say("Weighed: {weight}, C at {place}, known within {radius}.",
             {weight, at, length_up(of.shown.com_radius, units)});
}

std::string misfit_of_readings(const Reported& of) {
  if (!of.placement.weighing || of.report.readings_fit->fit) return {};
  const ReadingsFit& fit = *of.report.readings_fit;
  const Units& units = of.shown.units;
  const auto off = [&](std::size_t i) {
    const double by = fit.too_little[i];
    return say(by > 0 ? "{amount} too little" : "{amount} too much",
               {load_in_words(std::fabs(by), units, Toward::nearest)});
  };
  std::string text = say("W and C are right if each reading is.") + " ";
  if (fit.suspect) {
    text += say(
        "Equally stiff supports on even ground would read otherwise: the ground is uneven, the "
        "object bends, or a reading is wrong; if it is that of support {robot}, it reads {amount}.",
        {*fit.suspect + 1, off(*fit.suspect)});
  } else {
    double most = 0;
    for (const double by : fit.too_little) most = std::max(most, std::fabs(by));
    text +=
        say("Equally stiff supports on even ground would read otherwise: the ground is uneven, the "
            "object bends, or a reading is wrong by up to {amount}.",
            {load_in_words(most, units, Toward::nearest)});
  }
  text += " " + say("To be sure, lift, set down and read again.");
  const auto& give = of.shown.carrying.give;
  const Weighing& weighing = *of.placement.weighing;
  if (give && weighing.weight > 0) {
    double most = 0;
    for (const double r : weighing.residuals) most = std::max(most, std::fabs(r));
    const auto& spread = weighing.spread;  // above 0 for those that carry
    const auto m = static_cast<double>(
        std::count_if(spread.begin(), spread.end(), [](double each) { return each > 0; }));
    text += " " + say("Heights that are off by up to {amount} explain them, too.",
                      {length_up(most * *give * m / weighing.weight, units)});
  }
  return text;
}

std::string weighing_in_words(const Reported& of) {
  const auto& weighing = of.placement.weighing;
  if (!weighing) return {};
  std::string text = weighed_in_words(of);
  const auto add = [&](const std::string& sentence) {
    if (!sentence.empty()) text += " " + sentence;
  };
  if (weighing->weight_error > 0)
    add(say("The weight may be off by up to {amount}.",
            {load_in_words(weighing->weight_error, of.shown.units, Toward::up)}));
  if (of.placement.settings.weighed.level_error > 0 && !of.shown.carrying.has_height())
    add(say("The error of level counts only with the height of C."));
  if (weighing->height) add(height_in_words(of, *weighing->height));
  add(misfit_of_readings(of));
  return text;
}

std::string use_in_words(const std::optional<double>& use) {
  return use ? significant(100 * *use, 3, Toward::up) + "\u00A0%" : nothing;
}

std::string use_in_words(const Reported& of) {
  const auto most = of.report.most_used();
  if (!most || !of.placement.loads || of.report.tips) return {};
  const Carrying& carrying = of.shown.carrying;
  const std::string use = use_in_words(of.report.use[*most]), factor = plain(carrying.dynamic),
                    robot = of.placement.called(*most);
  return carrying.weight_doubt > 0
             ? say("Robot {robot} is used to {use}, with a dynamic factor of {factor} and a weight "
                   "that may be off by {amount}.",
                   {robot, use, factor, slope_in_words(carrying.weight_doubt)})
             : say("Robot {robot} is used to {use}, with a dynamic factor of {factor} and the weight "
                   "as given.",
                   {robot, use, factor});
}

CaseInWords headings_of_cases(const Reported& of) {
  const std::string_view unit = name(of.shown.units.weight);
  return {say("case"),
          say("greatest load, {unit}", {unit}),
          say("of robot"),
          say("least load, {unit}", {unit}),
          of.report.has_capacities ? say("use") : std::string(),
          say("stays")};
}

namespace {

std::string name_of_case(const LoadCase& each, const Reported& of) {
  const Carrying& carrying = of.shown.carrying;
  const Units& units = of.shown.units;
  switch (each.kind) {
    case LoadCase::Kind::level:
      return say("as given, level and still");
    case LoadCase::Kind::com:
      return say("C off by up to {amount}", {given_length(of.shown.com_radius, units)});
    case LoadCase::Kind::slope:
      return say("on slopes up to {amount}", {slope_in_words(carrying.slope)});
    case LoadCase::Kind::acceleration:
      return say("braked at up to {amount}",
                 {significant(carrying.acceleration, 3, Toward::nearest) + "\u00A0g"});
    case LoadCase::Kind::uneven:
      return say("heights off by up to {amount}", {given_length(carrying.uneven, units)});
    case LoadCase::Kind::all:
      return say("all of these");
    case LoadCase::Kind::failure:
      return of.report.disturbance.any()
                 ? say("all of these, and robot {robot} fails", {of.placement.called(*each.failed)})
                 : say("robot {robot} fails", {of.placement.called(*each.failed)});
  }
  return {};
}

}  // namespace

std::vector<CaseInWords> cases_in_words(const Reported& of, const std::vector<LoadCase>& cases) {
  double largest = 0;
  for (const LoadCase& each : cases) largest = std::max(largest, each.greatest.value_or(0));
  std::vector<CaseInWords> rows;
  for (const LoadCase& each : cases)
    rows.push_back({name_of_case(each, of),
                    each.greatest ? amount(*each.greatest, largest, Toward::up) : nothing,
                    each.robot ? of.placement.called(*each.robot) : nothing,
                    each.least ? amount(*each.least, largest, Toward::down) : nothing,
                    of.report.has_capacities ? use_in_words(each.use) : std::string(),
                    !each.stays                 ? say("no")
                    : each.use && *each.use > 1 ? say("yes, but overloaded")
                                                : say("yes")});
  return rows;
}

}  // namespace evenlift
