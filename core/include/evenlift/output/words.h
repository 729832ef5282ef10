// Numbers and results in words. The program, the page, pictures, lessons and experiments all use
// them, so that all say the same. Texts are plain English in UTF-8, the same bytes on every
// platform.
//
// A number is rounded as people round the decimal that shortest() prints: to the nearest, and a
// half away from zero. So 2.345 is 2.35 with two decimals, although its double is a little less.
// The minus sign is "−", and zero never has one. A no-break space (U+00A0) parts a number from its
// unit.
#pragma once

#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"

namespace evenlift {

// --- Numbers. All O(1).

// With exactly `decimals` (0 .. 9) digits after the point. From 1e15 on as plain().
std::string fixed(double value, int decimals);

// With the fewest digits that read back to the same number: "100", "0.8".
std::string plain(double value);

// With `digits` significant digits, zeros at the end left out: "0.00167", "1.67e−21".
std::string significant(double value, int digits);

// The number of decimals, at most 9, that shows `largest` with three significant digits. Smaller
// values of the same kind get as many.
int decimals_for(double largest);

// A value with decimals_for(largest), where `largest` is the largest value of a column: so all of
// them line up. Where that would be a long row of zeros or of digits, below 1e-6 and from 1e12 on,
// three significant digits.
std::string amount(double value, double largest);

// "15.2–18.1", or one number where both look the same.
std::string amounts(double low, double high, double largest);

// A load or weight with its unit: "16.7 kg".
std::string load_in_words(double value, double largest, const Units& units);

// The same of a range: "15.2–18.1 kg".
std::string load_in_words(double low, double high, double largest, const Units& units);

// What a robot bears by a model, without and with its unit: such a range, or "≤ 18.1" where the
// model only bounds it from above (at best and at worst).
std::string amounts(LoadModel model, const LoadRange& load, double largest);
std::string load_in_words(LoadModel model, const LoadRange& load, double largest,
                          const Units& units);

// A number that is a weight or a length already, with its unit: "100 kg", "2.5 mm". Lengths may
// have none: "2.5".
std::string with_weight_unit(const std::string& number, const Units& units);

// A weight or capacity that somebody gave, with its unit: all of its whole part, and six
// significant digits at most, since one that was converted from another unit has many: "100 kg",
// "22.6796 kg".
std::string given_weight(double weight, const Units& units);
std::string with_length_unit(const std::string& number, const Units& units);

// A length that is promised, so never more than it is: its first two digits, as "12" for 12.9.
std::string promised_length(double length, const Units& units);

// A share of 1 as a percentage: "81 %". Only 0 is "0 %" and only 1 is "100 %", both within
// tolerance; what would be rounded to them is "< 1 %" or "> 99 %" (with one decimal "< 0.1 %").
std::string percentage(double share, int decimals = 0);

// How many percentage points a share is ahead of another: the difference of the two percentages
// with two decimals.
std::string points_ahead(double share, double other);

// "1 team", "3 teams".
std::string count_of(std::size_t n, const char* one, const char* many);

// A load ratio: three decimals.
std::string ratio_in_words(double ratio);

// A point that somebody gave: to six significant digits, "(3.5, −2)".
std::string given_point(const Vec2& point);

// "(3.5, −2.0)" with a fixed number of decimals. coordinate_decimals() is the number that shows
// where something is on a polygon: four significant digits of the polygon's size, at most 9.
std::string point_in_words(const Vec2& point, int decimals);
int coordinate_decimals(const Points& vertices);  // O(n)

// --- A placement. O(1) unless stated otherwise.

// "6 robots carry 15.2–18.1 kg each (100 kg in all).", of balanced robots "6 robots carry 16.7 kg
// each, all the same (100 kg in all).", or "No team can be placed." The loads are the plan's: where
// those of another model are `shown`, it begins with "As planned". Where C is known only within a
// distance and the `ranges` of the plan's loads are given (loads_by), these are said: "6 robots
// carry 14.9–18.4 kg each, with C known within 3 cm (100 kg in all)." O(m).
std::string loads_in_words(const ShownPlacement& of, LoadModel shown = LoadModel::plan,
                           const std::vector<LoadRange>& ranges = {});

// Why there are no teams, and what could help; or that there are fewer than were asked for; else
// empty.
std::string shortage_in_words(const Placement& placement);

// "A push down on 81 % of the object does not tip it." Empty with no team.
std::string coverage_in_words(const Placement& placement);

// "It can still turn clockwise." or what holds it, and how far robots may be off; or which robot
// must stand exactly, since it is beside a corner. Empty with no team.
std::string closure_in_words(const ShownPlacement& of);

// "turn either way and slide"; empty if nothing is free.
std::string free_motions_in_words(const Closure& closure);

// Whether the robots hold the object, if only to second order; in form closure only if they
// hold_clearly() (placement.h).
bool is_held(const Placement& placement);

// A result that covers less of the object than this is not a good one.
inline constexpr double good_coverage = 0.5;

// The sentences that follow loads_in_words: shortage, coverage and closure; what is wrong comes
// first.
std::string detail_in_words(const ShownPlacement& of);

// The whole result in a few sentences: loads_in_words and detail_in_words.
std::string verdict(const ShownPlacement& of, LoadModel shown = LoadModel::plan,
                    const std::vector<LoadRange>& ranges = {});

// Why a robot cannot stand at a part of the boundary: "a robot of radius 60 mm does not fit here",
// with the size that is in the way.
std::string unusable_in_words(WhyUnusable why, const RobotSize& robot, const Units& units);

// "No robot touches edge 1 between 31 % and 76 % of its length, nor edge 3." Empty if all of the
// boundary is allowed. O(1): many parts are only counted.
std::string no_go_in_words(const std::vector<EdgePart>& no_go);

// Which robots carry more than one can, and how many robots are needed if the plan for that is
// known, and that for any one failing. O(teams).
std::string capacity_in_words(const ShownPlacement& of, double capacity, const CapacityPlan* plan,
                              const FailurePlan* if_one_fails = nullptr);

// The same where other robots are overloaded than by plan: those by this model of the loads, or
// those of the others while the robot `failed` (from 0) fails. The plan knows neither, and the
// words say so.
std::string capacity_in_words(const ShownPlacement& of, double capacity, const CapacityPlan* plan,
                              const std::vector<std::size_t>& overloaded, LoadModel model,
                              const std::optional<std::size_t>& failed = std::nullopt,
                              const FailurePlan* if_one_fails = nullptr);

// One of the numbers that describe a result, with a few words on what it means.
struct Fact {
  const char* label;
  std::string value;
  const char* about;
};
std::vector<Fact> facts_in_words(const ShownPlacement& of);

// A team's numbers, with those of its robots in their order. O(robots of the team).
struct TeamInWords {
  std::string ratio;
  std::string length;                  // of the chord of a team of two, else empty
  std::vector<std::string> at, loads;  // of each robot; loads without their unit
};
TeamInWords team_in_words(const Placement& placement, std::size_t team, int coordinate_decimals);

// "yes", "second order" or "no".
std::string form_closure_in_words(const Closure& closure);

// The closure's margin: three decimals, more if it is small.
std::string margin_in_words(double margin);
int margin_decimals(double margin);

// "Edges 2 and 7 cross, touch or overlap": a sentence without a full stop. The name of a setting
// comes first only where the words do not say which one it is.
std::string sentence(const InputError& error);

}  // namespace evenlift
