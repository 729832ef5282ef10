// Numbers and results in words, the same in the program, the page, pictures, lessons and
// experiments. Texts are in plain English or the reader's language (wording.h), in UTF-8, with the
// same bytes on every platform.
//
// Numbers are rounded from the decimal that shortest() prints, to the nearest, and a half away from
// zero: 2.345 is 2.35 with two decimals, although its double is slightly less. The minus sign is
// "−", and zero never has one. A no-break space (U+00A0) separates a number from its unit.
#pragma once

#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"

namespace evenlift {

// --- Numbers. All O(1).

// With exactly `decimals` (0 .. 9) digits after the point; from 1e15 on, as plain().
std::string fixed(double value, int decimals);

// With the fewest digits that read back to the same number: "100", "0.8".
std::string plain(double value);

// With `digits` significant digits, without trailing zeros: "0.00167", "1.67e−21".
std::string significant(double value, int digits);

// The number of decimals, at most 9, that shows `largest` with three significant digits; use it
// also for smaller values of the same kind.
int decimals_for(double largest);

// With decimals_for(largest), where `largest` is the largest value of a column, so that the column
// lines up. For `largest` below 1e-6 or from 1e12 on, three significant digits instead of a long
// row of digits.
std::string amount(double value, double largest);

// "15.2–18.1", or one number if both look the same.
std::string amounts(double low, double high, double largest);

// With its unit: "16.7 kg", "15.2–18.1 kg".
std::string load_in_words(double value, double largest, const Units& units);

std::string load_in_words(double low, double high, double largest, const Units& units);

// A load by a model, without and with its unit: a range, or "≤ 18.1" if the model gives only an
// upper bound (best and worst).
std::string amounts(LoadModel model, const LoadRange& load, double largest);
std::string load_in_words(LoadModel model, const LoadRange& load, double largest,
                          const Units& units);

// A number that is already text, with its unit: "100 kg", "2.5 mm"; "2.5" for lengths without a
// unit.
std::string with_weight_unit(const std::string& number, const Units& units);

// A weight or capacity that the user gave: at most six significant digits, or its whole part if
// that has more, since a value converted from another unit has many: "100 kg", "22.6796 kg".
std::string given_weight(double weight, const Units& units);
std::string with_length_unit(const std::string& number, const Units& units);

// A guaranteed length, rounded down to two significant digits: "12" for 12.9.
std::string promised_length(double length, const Units& units);

// "81 %". Only 0 is "0 %" and only 1 is "100 %", both within tolerance; other shares that would
// round to these are "< 1 %" or "> 99 %" (with one decimal "< 0.1 %").
std::string percentage(double share, int decimals = 0);

// The lead of a share in percentage points: the difference of the two percentages, each rounded to
// two decimals.
std::string points_ahead(double share, double other);

// "1 team", "3 teams".
std::string count_of(std::size_t n, const char* one, const char* many);

// "area", "equal angles", "by hand".
std::string method_in_words(Method method);

// With three decimals.
std::string ratio_in_words(double ratio);

// A point that the user gave, to six significant digits: "(3.5, −2)".
std::string given_point(const Vec2& point);

// "(3.5, −2.0)" with a fixed number of decimals. coordinate_decimals() returns those for four
// significant digits of the polygon's size, at most 9.
std::string point_in_words(const Vec2& point, int decimals);
int coordinate_decimals(const Points& vertices);  // O(n)

// --- A placement. O(1) unless stated otherwise.

// "6 robots carry 15.2–18.1 kg each (100 kg in all).", for balanced robots "6 robots carry equal
// loads of 16.7 kg (100 kg in all).", with cargo "… (120 kg with its cargo of 24 kg).", or "No team
// can be placed." The loads are as planned, and the text begins with "As planned" if another model
// is `shown`. With a disturbance and the `ranges` of the planned loads (loads_by): "6 robots carry
// 14.9–18.4 kg each, with a C uncertainty of 3 cm, on slopes up to 8 % (100 kg in all)." For given
// supports the text says that the loads are those of equally stiff robots, unless equilibrium alone
// determines them; or "It falls: the centre of mass is 12 mm outside the lifting base, beyond
// robots 2 and 3." O(m log m).
std::string loads_in_words(const ShownPlacement& of, LoadModel shown = LoadModel::plan,
                           const std::vector<LoadRange>& ranges = {});

// "120 kg with its cargo of 24 kg", or "100 kg". O(items).
std::string weight_in_words(const ShownPlacement& of);

// "4 vertices, 12 holes", or "4 vertices".
std::string outline_in_words(const PolygonWithHoles& object);

// Why there are no teams, and what could help; or that there are fewer than requested; or empty.
std::string shortage_in_words(const Placement& placement);

// "81 % of the object can be pressed down on without tipping it." Empty without teams, or if the
// object falls.
std::string coverage_in_words(const Placement& placement);

// "It can still turn clockwise.", or what holds it and how far robots may be off, or which robot
// must stand exactly in place near a corner. Empty without teams.
std::string closure_in_words(const ShownPlacement& of);

// "turn either way and slide"; empty if no motion is free.
std::string free_motions_in_words(const Closure& closure);

// At least to second order; in form closure, only if they hold_clearly() (placement.h).
bool is_held(const Placement& placement);

// The least of a good result.
inline constexpr double good_coverage = 0.5;

// What follows loads_in_words(): shortage, coverage and closure, with problems first.
std::string detail_in_words(const ShownPlacement& of);

// loads_in_words() and detail_in_words().
std::string verdict(const ShownPlacement& of, LoadModel shown = LoadModel::plan,
                    const std::vector<LoadRange>& ranges = {});

// With the size that prevents it: "a robot of radius 60 mm does not fit here".
std::string unusable_in_words(WhyUnusable why, const RobotSize& robot, const Units& units);

// "No robot touches edge 1 between 31 % and 76 % of its length, nor edge 3." Empty if the whole
// boundary is allowed; for many parts, only their number. O(1).
std::string no_go_in_words(const std::vector<EdgePart>& no_go);

// "20 kg", or "its capacity" if robots have their own. Some robot must have a capacity.
std::string limit_in_words(const ShownPlacement& of);

// The overloaded robots, the number of robots needed if the plan is known, and the number needed if
// any one may fail. O(teams).
std::string capacity_in_words(const ShownPlacement& of, const CapacityPlan* plan,
                              const FailurePlan* if_one_fails = nullptr);

// The same for robots overloaded by this load model, or while the robot `failed` (from 0) fails.
// `plan` covers neither case, and the text states this.
std::string capacity_in_words(const ShownPlacement& of, const CapacityPlan* plan,
                              const std::vector<std::size_t>& overloaded, LoadModel model,
                              const std::optional<std::size_t>& failed = std::nullopt,
                              const FailurePlan* if_one_fails = nullptr);

struct Fact {
  const char* label;
  std::string value;
  const char* about;
};
std::vector<Fact> facts_in_words(const ShownPlacement& of);

// With those of its robots in order. O(robots of the team).
struct TeamInWords {
  std::string ratio;
  std::string length;                  // of the chord of a team of two, or empty
  std::vector<std::string> at, loads;  // of each robot; loads without unit
};
TeamInWords team_in_words(const Placement& placement, std::size_t team, int coordinate_decimals);

// "yes", "second order" or "no".
std::string form_closure_in_words(const Closure& closure);

// With three decimals, or more if it is small.
std::string margin_in_words(double margin);
int margin_decimals(double margin);

// "Edges 2 and 7 cross, touch or overlap": the error without a full stop. It begins with the name
// of a setting only if the words do not identify that.
std::string sentence(const InputError& error);

}  // namespace evenlift
