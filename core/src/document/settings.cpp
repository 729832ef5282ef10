#include "evenlift/settings.h"

#include <iterator>

#include "document/setting_values.h"
#include "evenlift/numbers.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

// --- The functions of a row, from the path to its member

auto& holder(auto& document, auto Settings::*) { return document.settings; }
auto& holder(auto& document, auto Shown::*) { return document.shown; }
auto& holder(auto& document, auto Document::*) { return document; }

template <auto first, auto... rest>
auto& at(auto& document) {
  return ((holder(document, first).*first).*....*rest);
}

template <class Value>
struct Bare {
  using type = Value;
};
template <class Value>
struct Bare<std::optional<Value>> {
  using type = Value;
};

template <class Value>
constexpr bool is_plain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

template <auto... path>
constexpr SettingRow::Access of() {
  using Member = std::remove_cvref_t<decltype(at<path...>(std::declval<Document&>()))>;
  using Value = typename Bare<Member>::type;
  SettingRow::Access access{
      [](std::string_view text, const SettingRange& range, Document& document) {
        return setting_value::take(text, range, at<path...>(document));
      },
      [](const Document& document, const SettingRange& range) {
        return setting_value::text_of(at<path...>(document), range);
      },
      [](const Document& document, const SettingRange& range) {
        return setting_value::is_within(at<path...>(document), range);
      },
      nullptr,
      std::is_arithmetic_v<Value>,
      std::is_integral_v<Value>};
  if constexpr (is_plain<Value>) access.kind = setting_value::kind_in_words<Value>;
  if constexpr (std::is_enum_v<Value>) access.names = setting_value::name_at<Value>;
  return access;
}

// read_size() turns -0 into 0, so that both give one document.
template <double RobotSize::*part>
constexpr SettingRow::Access part_of_robot() {
  SettingRow::Access access = of<&Settings::robot, part>();
  access.read = [](std::string_view text, const SettingRange&, Document& document) {
    return read_size(text, document.settings.robot.*part);
  };
  return access;
}

// Supports; their text also sets capacities and method.
constexpr SettingRow::Access supports_with_capacities() {
  SettingRow::Access access = of<&Settings::supports>();
  access.read = [](std::string_view text, const SettingRange&, Document& document) {
    return read_supports(text, document);
  };
  return access;
}
constexpr SettingRow::Access of_supports = supports_with_capacities();

// The slope, also as a percentage or an angle.
constexpr SettingRow::Access slope_as_text() {
  SettingRow::Access access = of<&Shown::carrying, &Carrying::slope>();
  access.read = [](std::string_view text, const SettingRange& range, Document& document) {
    return read_slope(text, range, document.shown.carrying.slope);
  };
  access.kind = nullptr;  // its row has a rule
  return access;
}

// The acceleration, also with its unit.
constexpr SettingRow::Access acceleration_as_text() {
  SettingRow::Access access = of<&Shown::carrying, &Carrying::acceleration>();
  access.read = [](std::string_view text, const SettingRange& range, Document& document) {
    return read_acceleration(text, range, document.shown.carrying.acceleration);
  };
  return access;
}

// A part of all, also as a percentage.
constexpr SettingRow::Access weight_doubt_as_text() {
  SettingRow::Access access = of<&Shown::carrying, &Carrying::weight_doubt>();
  access.read = [](std::string_view text, const SettingRange& range, Document& document) {
    return read_part_of_all(text, range, document.shown.carrying.weight_doubt);
  };
  access.kind = nullptr;  // its row has a rule
  return access;
}

template <double Weighed::*member>
constexpr SettingRow::Access slope_of_weighing() {
  SettingRow::Access access = of<&Settings::weighed, member>();
  access.read = [](std::string_view text, const SettingRange& range, Document& document) {
    return read_slope(text, range, document.settings.weighed.*member);
  };
  access.kind = nullptr;  // its row has a rule
  return access;
}

constexpr SettingRow::Access heading_as_text() {
  return {
      [](std::string_view text, const SettingRange&, Document& document) {
        return read_direction(text, document.settings.weighed.heading);
      },
      [](const Document& document, const SettingRange&) {
        const auto& heading = document.settings.weighed.heading;
        return heading ? shortest(heading->x) + "," + shortest(heading->y) : std::string("none");
      },
      [](const Document& document, const SettingRange&) {
        const auto& heading = document.settings.weighed.heading;
        return !heading ||
               (max_norm(*heading) <= max_coordinate && max_norm(*heading) >= 1 / max_coordinate);
      },
      nullptr};
}

// A list whose refusal quotes the refused part.
constexpr SettingRow::Access quoting(SettingRow::Access access,
                                     std::string_view (*refused)(std::string_view)) {
  access.refused = refused;
  return access;
}

constexpr SettingRow::Access of_the_view = {
    [](std::string_view, const SettingRange&, Document&) { return false; },
    [](const Document&, const SettingRange&) { return std::string(); },
    [](const Document&, const SettingRange&) { return true; }, nullptr};

constexpr SettingRange any_length{0, max_length}, any_weight{min_weight, max_weight};

// --- The table

constexpr SettingRow rows[] = {
    {.setting = Setting::teams,
     .name = "teams",
     .subject = "the number of teams",
     .edit = "the number of teams",
     .counts_for = CountsFor::placing,
     .range = {1, max_teams, "max"},
     .option = {OptionGroup::placement, "N",
                "number of teams, or max for every candidate (default 3)"},
     .in_document = Listed::always,
     .plans = false,
     .access = of<&Settings::teams>()},
    {.setting = Setting::method,
     .name = "metric",
     .alias = "method",
     .subject = "the method",
     .edit = "the method",
     .option = {OptionGroup::placement, "NAME",
                "area (default), circle, distance, distributed, random, balanced or given"},
     .in_document = Listed::always,
     .in_result = Listed::always,
     .access = of<&Settings::method>()},
    {.setting = Setting::min_ratio,
     .name = "min_ratio",
     .subject = "the minimum load ratio",
     .edit = "the minimum load ratio",
     .counts_for = CountsFor::placing,
     .range = {0, 1},
     .option = {OptionGroup::placement, "R", "minimum load ratio, 0 to 1 (default 0.8)"},
     .in_document = Listed::always,
     .in_result = Listed::always,
     .access = of<&Settings::min_ratio>()},
    {.setting = Setting::com,
     .name = "com",
     .subject = "the centre of mass",
     .rule = "must be two numbers X,Y, or centroid",
     .option = {OptionGroup::placement, "X,Y",
                "centre of mass (default the file's, else the centroid)"},
     .is_length = true,
     .access = of<&Document::centre_of_mass>()},
    {.setting = Setting::weight,
     .name = "weight",
     .subject = "the weight",
     .edit = "the weight",
     .changes = Changes::loads,
     .range = any_weight,
     .option = {OptionGroup::placement, "W", "the object's weight (default 100)"},
     .in_document = Listed::always,
     .in_result = Listed::always,
     .is_weight = true,
     .access = of<&Settings::weight>()},
    {.setting = Setting::seed,
     .name = "seed",
     .subject = "the seed",
     .edit = "the seed",
     .counts_for = CountsFor::placing,
     .option = {OptionGroup::placement, "S", "for the method random (default 1)"},
     .in_document = Listed::always,
     .in_result = Listed::always,
     .access = of<&Settings::seed>()},
    {.setting = Setting::overlays,
     .name = "overlays",
     .subject = "the overlays",
     .changes = Changes::shown,
     .rule =
         "must be none or some of candidates, chords, hull, clockwise, counterclockwise, tipping, halo, "
         "tilt and load",
     .option = {OptionGroup::none, {}, "what a picture or link shows"},
     .in_document = Listed::always,
     .plans = false,
     .told = false,
     .access = of<&Shown::overlays>()},
    {.setting = Setting::step,
     .name = "step",
     .subject = "the step",
     .changes = Changes::shown,
     .range = {0, 4294967295.0, "none"},
     .option = {OptionGroup::none, {}, "step of the walkthrough that a link opens"},
     .in_document = Listed::always,
     .plans = false,
     .told = false,
     .access = of<&Shown::step>()},
    {.setting = Setting::com_radius,
     .name = "com_radius",
     .subject = "the uncertainty of the centre of mass",
     .edit = "the C uncertainty",
     .changes = Changes::shown,
     .range = any_length,
     .option =
         {OptionGroup::uncertainty, "E",
          "C uncertainty: the radius within which the centre of mass is known; loads become ranges"},
     .record = 7,
     .in_document = Listed::always,
     .is_length = true,
     .access = of<&Shown::com_radius>()},
    {.setting = Setting::capacity,
     .name = "capacity",
     .subject = "the capacity of a robot",
     .edit = "the capacity",
     .changes = Changes::shown,
     .range = {min_weight, max_weight, "none"},
     .option =
         {OptionGroup::uncertainty, "K",
          "load that one robot can carry: overloaded robots, and the number of robots needed"},
     .record = 8,
     .in_document = Listed::always,
     .is_weight = true,
     .access = of<&Shown::capacity>()},
    {.setting = Setting::robot,
     .name = "robot",
     .subject = "the size of a robot",
     .edit = "the size of the robots",
     .rule =
         "must be none or some of r, reach, depth, width and gap with numbers from 0 to 1000000000, such as r=30,reach=5",
     .option =
         {OptionGroup::placement, "r=R,reach=G,...",
          "size of a robot: r, reach, depth and width of the hand, and the gap between robots"},
     .record = 9,
     .in_document = Listed::always,
     .access = of<&Settings::robot>()},
    {.setting = Setting::no_go,
     .name = "no_go",
     .subject = "the no-go edges",
     .edit = "the no-go edges",
     .rule =
         "must be none, or at most 1000 edges from 1 or parts of them from 0 to 1, such as 3,5:0.25-0.75",
     .option = {OptionGroup::placement, "E[:FROM-TO],...",
                "no-go edges from 1, or parts of them from 0 to 1"},
     .record = 10,
     .in_document = Listed::always,
     .access = quoting(of<&Settings::no_go>(), refused_part)},
    {.setting = Setting::unit,
     .name = "unit",
     .subject = "the unit of lengths",
     .changes = Changes::shown,
     .option = {OptionGroup::units, "U", "label of lengths: m, cm, mm or in (default none)"},
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .told = false,
     .access = of<&Shown::units, &Units::length>()},
    {.setting = Setting::weight_unit,
     .name = "weight_unit",
     .subject = "the unit of weights",
     .changes = Changes::shown,
     .option = {OptionGroup::units, "U", "label of weights: kg (default), t, N or lb"},
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .told = false,
     .access = of<&Shown::units, &Units::weight>()},
    {.setting = Setting::goal,
     .name = "goal",
     .subject = "the goal",
     .edit = "the goal or its limits",
     .counts_for = CountsFor::placing,
     .option = {OptionGroup::placement, "GOAL",
                "cover: the widest lifting base; hold: a hold with the minimum margin first"},
     .record = 2,
     .in_document = Listed::always,
     .access = of<&Settings::goal>()},
    {.setting = Setting::robots,
     .name = "robots",
     .subject = "the number of robots",
     .edit = "the number of robots",
     .counts_for = CountsFor::balanced,
     .range = {least_robots, most_robots},
     .option = {OptionGroup::placement, "M", "number of balanced robots, 2 to 64 (default 6)"},
     .record = 1,
     .json = "requested_robots",
     .in_document = Listed::always,
     .in_result = Listed::always,
     .plans = false,
     .access = of<&Settings::robots>()},
    {.setting = Setting::positions,
     .name = "positions",
     .subject = "the positions",
     .edit = "the positions",
     .counts_for = CountsFor::candidates,
     .option = {OptionGroup::placement, "WHERE",
                "best: one place for two edges; range: anywhere in their range"},
     .record = 6,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .access = of<&Settings::positions>()},
    {.setting = Setting::min_margin,
     .name = "min_margin",
     .subject = "the minimum margin",
     .edit = "the goal or its limits",
     .counts_for = CountsFor::hold_requirements,
     .range = {0, 1},
     .option = {OptionGroup::placement, "F", "minimum margin of a hold (default 0.05)"},
     .record = 3,
     .in_document = Listed::always,
     .in_result = Listed::always,
     .access = of<&Settings::min_margin>()},
    {.setting = Setting::apart,
     .name = "apart",
     .subject = "the minimum distance between robots",
     .edit = "the goal or its limits",
     .counts_for = CountsFor::balanced,
     .range = any_length,
     .option = {OptionGroup::placement, "A",
                "preferred minimum distance between robots (default 0.12 of the object's radius)"},
     .record = 4,
     .in_document = Listed::always,
     .in_result = Listed::always,
     .is_length = true,
     .access = of<&Settings::apart>()},
    {.setting = Setting::survive,
     .name = "survive",
     .subject = "the number of failures to survive",
     .edit = "the goal or its limits",
     .counts_for = CountsFor::balanced,
     .range = {0, most_survived},
     .option = {OptionGroup::placement, "F",
                "number of failures that balanced robots should survive (default 0)"},
     .record = 5,
     .in_document = Listed::always,
     .in_result = Listed::always,
     .access = of<&Settings::survive>()},
    {.setting = Setting::clear,
     .name = "clear",
     .subject = "the clearance",
     .edit = "the goal or its limits",
     .range = any_length,
     .option =
         {OptionGroup::placement, "K",
          "clearance: shorter distances are not relied on, of contacts from corners and, after a failure, "
          "of the centre of mass from the edge of the lifting base (default 0.02 of the object's radius)"},
     .record = 20,
     .in_document = Listed::always,
     .in_result = Listed::always,
     .is_length = true,
     .access = of<&Settings::clear>()},
    {.setting = Setting::accuracy,
     .name = "accuracy",
     .subject = "the accuracy",
     .edit = "the accuracy",
     .range = any_length,
     .option = {OptionGroup::placement, "A",
                "robots may be off their places by A: searches keep what they promise (default 0)"},
     .record = 30,
     .in_document = Listed::if_changed,
     .is_length = true,
     .access = of<&Settings::accuracy>()},
    {.setting = Setting::robot_radius,
     .name = "robot_radius",
     .subject = "the radius of a robot",
     .range = any_length,
     .option = {OptionGroup::none,
                {},
                "radius of the round body; it overrides that of robot, like the next four"},
     .is_length = true,
     .access = part_of_robot<&RobotSize::radius>()},
    {.setting = Setting::robot_reach,
     .name = "robot_reach",
     .subject = "the reach of a robot's arm",
     .range = any_length,
     .option = {OptionGroup::none, {}, "length of the arm, from the body to the contact"},
     .is_length = true,
     .access = part_of_robot<&RobotSize::reach>()},
    {.setting = Setting::robot_depth,
     .name = "robot_depth",
     .subject = "the depth of a robot's hand",
     .range = any_length,
     .option = {OptionGroup::none, {}, "length of the hand, from the contact to the lifting point"},
     .is_length = true,
     .access = part_of_robot<&RobotSize::depth>()},
    {.setting = Setting::robot_width,
     .name = "robot_width",
     .subject = "the width of a robot's hand",
     .range = any_length,
     .option = {OptionGroup::none, {}, "width of the hand"},
     .is_length = true,
     .access = part_of_robot<&RobotSize::width>()},
    {.setting = Setting::robot_gap,
     .name = "robot_gap",
     .subject = "the gap between robots",
     .range = any_length,
     .option = {OptionGroup::none, {}, "free distance between two bodies"},
     .is_length = true,
     .access = part_of_robot<&RobotSize::gap>()},
    {.setting = Setting::supports,
     .name = "supports",
     .subject = "the supports",
     .edit = "the robots",
     .counts_for = CountsFor::given,
     .rule = "must be 1 to 1000 points X,Y with spaces between them, such as 0,0 160,0 80,90, each "
             "perhaps with its capacity as X,Y@K and a name of at most 60 characters as X,Y@K:NAME "
             "or X,Y:NAME; or none",
     .option =
         {OptionGroup::placement, "\"X,Y[@K][:NAME] ...\"",
          "robots that already stand, each perhaps with its capacity and name; or a file of them"},
     .record = 21,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = quoting(of_supports, refused_support)},
    {.setting = Setting::snap,
     .name = "snap",
     .subject = "the snap distance",
     .edit = "the snap distance",
     .counts_for = CountsFor::given,
     .range = any_length,
     .option = {OptionGroup::placement, "S",
                "supports within S of the outline stand at the edge (default 1e-4 of its size)"},
     .record = 22,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .is_length = true,
     .plans = false,
     .access = of<&Settings::snap>()},
    {.setting = Setting::support_capacities,
     .name = "support_capacities",
     .subject = "the capacities of the supports",
     .edit = "the capacities of the supports",
     .changes = Changes::shown,
     .counts_for = CountsFor::given,
     .rule = "must be a number greater than 0, or none, for each support, such as 30,none,40; or "
             "nothing",
     .option =
         {OptionGroup::none,
          {},
          "capacity of each support, as many as there are supports; it overrides those in supports"},
     .record = 17,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = of<&Shown::support_capacities>()},
    {.setting = Setting::support_names,
     .name = "support_names",
     .subject = "the names of the supports",
     .edit = "the names of the supports",
     .changes = Changes::loads,
     .counts_for = CountsFor::given,
     .rule =
         "must be a name of at most 60 characters for each support, with spaces between them, such "
         "as north \"south west\"; or none",
     .option =
         {OptionGroup::none,
          {},
          "name of each support, as many as there are supports; it overrides those in supports"},
     .record = 39,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = of<&Settings::support_names>()},
    {.setting = Setting::cargo,
     .name = "cargo",
     .subject = "the cargo",
     .edit = "the cargo",
     .rule = "must be 1 to 1000 loads X,Y:W with W above 0 and spaces between them, such as 8,8:24 "
             "2,3:1.5, each perhaps with a name of at most 60 characters as X,Y:W:NAME; or none",
     .option =
         {OptionGroup::placement, "\"X,Y:W[:NAME] ...\"",
          "loads that are fixed to the object, added to those of the file; none removes those"},
     .record = 12,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .access = quoting(of<&Settings::cargo>(), refused_cargo)},
    {.setting = Setting::com_height,
     .name = "com_height",
     .subject = "the height of the centre of mass",
     .edit = "the height of C",
     .changes = Changes::shown,
     .range = any_length,
     .option =
         {OptionGroup::uncertainty, "H",
          "height of the centre of mass, with cargo, above the lifting points: at which slope "
          "it tips"},
     .record = 15,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .is_length = true,
     .access = of<&Shown::carrying, &Carrying::com_height>()},
    {.setting = Setting::slope,
     .name = "slope",
     .subject = "the slope",
     .edit = "the slope",
     .changes = Changes::shown,
     .range = {0, max_slope},
     .rule = "must be a ratio from 0 to 1, a percentage such as 8%, or an angle such as 4.6deg",
     .option = {OptionGroup::uncertainty, "S",
                "greatest slope of the plane of the lifting points: a ratio, 8% or 4.6deg"},
     .record = 23,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .access = slope_as_text()},
    {.setting = Setting::acceleration,
     .name = "acceleration",
     .subject = "the acceleration",
     .edit = "the acceleration",
     .changes = Changes::shown,
     .range = {0, max_acceleration},
     .option = {OptionGroup::uncertainty, "A",
                "greatest acceleration along the ground in any direction, in g or such as 2m/s2"},
     .record = 24,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .access = acceleration_as_text()},
    {.setting = Setting::give,
     .name = "give",
     .subject = "how far a robot gives way",
     .edit = "how far a robot gives way",
     .changes = Changes::shown,
     .range = {min_length, max_length, "none"},
     .option = {OptionGroup::uncertainty, "G",
                "length by which a robot gives way under the mean load"},
     .record = 25,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .is_length = true,
     .access = of<&Shown::carrying, &Carrying::give>()},
    {.setting = Setting::uneven,
     .name = "uneven",
     .subject = "how uneven the ground is",
     .edit = "how uneven the ground is",
     .changes = Changes::shown,
     .range = any_length,
     .option = {OptionGroup::uncertainty, "U",
                "how much the ground or a robot's height is off at most; without --give, loads can "
                "reach those at worst"},
     .record = 26,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .is_length = true,
     .access = of<&Shown::carrying, &Carrying::uneven>()},
    {.setting = Setting::extra,
     .name = "extra",
     .subject = "the extra weight",
     .edit = "the extra weight",
     .changes = Changes::shown,
     .range = {min_weight, max_weight, "none"},
     .option = {OptionGroup::uncertainty, "W",
                "a further weight, such as a person: where it may stand"},
     .record = 27,
     .in_document = Listed::if_changed,
     .is_weight = true,
     .plans = false,
     .access = of<&Shown::carrying, &Carrying::extra>()},
    {.setting = Setting::readings,
     .name = "readings",
     .subject = "the readings",
     .edit = "the readings",
     .changes = Changes::loads,
     .counts_for = CountsFor::given,
     .range = {0, max_weight},
     .rule = "must be a weight of 0 or more for each support, with spaces between them, such as "
             "169 171 140 0; or none",
     .option = {OptionGroup::placement, "\"F ...\"",
                "what each support reads, without tare: gives the weight and the centre of mass"},
     .record = 31,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = of<&Settings::weighed, &Weighed::readings>()},
    {.setting = Setting::reading_error,
     .name = "reading_error",
     .subject = "the error of readings",
     .edit = "the error of readings",
     .changes = Changes::loads,
     .counts_for = CountsFor::given,
     .range = {0, max_weight},
     .rule = "must be a part of each reading from 0% to 100%, such as 1%, or a weight, such as 0.5",
     .option = {OptionGroup::placement, "D",
                "how far a reading may be off: a part of each, such as 1%, or a weight"},
     .record = 32,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = of<&Settings::weighed, &Weighed::error>()},
    {.setting = Setting::level_error,
     .name = "level_error",
     .subject = "the error of level",
     .edit = "the error of level",
     .changes = Changes::loads,
     .counts_for = CountsFor::given,
     .range = {0, max_slope},
     .rule = "must be a ratio from 0 to 1, a percentage such as 1%, or an angle such as 0.5deg",
     .option = {OptionGroup::placement, "S",
                "how far the lifting points may be from level while one reads, as a slope"},
     .record = 33,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = slope_of_weighing<&Weighed::level_error>()},
    {.setting = Setting::readings_tilted,
     .name = "readings_tilted",
     .subject = "the readings on a slope",
     .edit = "the readings",
     .changes = Changes::loads,
     .counts_for = CountsFor::given,
     .range = {0, max_weight},
     .rule = "must be a weight of 0 or more for each support, with spaces between them, such as "
             "160 171 149 0; or none",
     .option = {OptionGroup::placement, "\"F ...\"",
                "what each support reads on the slope of --tilted: gives the height of C"},
     .record = 34,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = of<&Settings::weighed, &Weighed::tilted_readings>()},
    {.setting = Setting::tilted,
     .name = "tilted",
     .subject = "the slope of the second weighing",
     .edit = "the slope of the second weighing",
     .changes = Changes::loads,
     .counts_for = CountsFor::given,
     .range = {0, max_slope},
     .rule = "must be a ratio from 0 to 1, a percentage such as 8%, or an angle such as 5deg",
     .option = {OptionGroup::placement, "S", "slope of the second weighing: a ratio, 8% or 5deg"},
     .record = 35,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = slope_of_weighing<&Weighed::tilted>()},
    {.setting = Setting::heading,
     .name = "heading",
     .subject = "the direction uphill",
     .edit = "the direction uphill",
     .changes = Changes::loads,
     .counts_for = CountsFor::given,
     .rule = "must be two numbers X,Y that are not both 0, an angle from the x axis such as 90deg, "
             "or none",
     .option = {OptionGroup::placement, "X,Y",
                "direction uphill of the second weighing: a vector, or an angle such as 90deg"},
     .record = 36,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .plans = false,
     .access = heading_as_text()},
    {.setting = Setting::dynamic,
     .name = "dynamic",
     .subject = "the dynamic factor",
     .edit = "the dynamic factor",
     .changes = Changes::shown,
     .range = {1, max_dynamic},
     .option =
         {OptionGroup::uncertainty, "F",
          "factor on the greatest loads before they meet a capacity, such as 1.2 (default 1)"},
     .record = 37,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .access = of<&Shown::carrying, &Carrying::dynamic>()},
    {.setting = Setting::weight_doubt,
     .name = "weight_doubt",
     .subject = "the uncertainty of the weight",
     .edit = "the uncertainty of the weight",
     .changes = Changes::shown,
     .range = {0, 1},
     .rule = "must be a part of the weight from 0 to 1, such as 0.05 or 5%",
     .option = {OptionGroup::uncertainty, "P",
                "how far the weight may be off, either way: a part of it, such as 5%"},
     .record = 38,
     .in_document = Listed::if_changed,
     .in_result = Listed::if_changed,
     .access = weight_doubt_as_text()},
    {.setting = Setting::loads,
     .name = "loads",
     .subject = "the load model",
     .changes = Changes::view,
     .rule = "must be plan, springs, best or worst",
     .access = of_the_view},
    {.setting = Setting::failed,
     .name = "failed",
     .subject = "the failed robot",
     .changes = Changes::view,
     .rule = "must be a whole number from 1, or none",
     .access = of_the_view},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < std::size(rows); ++i)
    if (rows[i].setting != static_cast<Setting>(i)) return false;
  return std::size(rows) == static_cast<std::size_t>(Setting::end_of_settings);
}
static_assert(in_order(), "row_of() finds a setting by its number, and each has a row");

}  // namespace

std::span<const SettingRow> all_settings() { return rows; }

const SettingRow& row_of(Setting setting) { return rows[static_cast<std::size_t>(setting)]; }

std::string_view name(Setting setting) { return row_of(setting).name; }

std::optional<Setting> setting_from_name(std::string_view text) {
  for (const SettingRow& row : rows)
    if (row.name == text || (!row.alias.empty() && row.alias == text)) return row.setting;
  return std::nullopt;
}

std::string hyphened(std::string_view name) {
  std::string text(name);
  for (char& c : text)
    if (c == '_') c = '-';
  return text;
}

bool counts(CountsFor placements, const Settings& settings) {
  const bool balanced = settings.method == Method::balanced;
  switch (placements) {
    case CountsFor::all:
      return true;
    case CountsFor::placing:
      return settings.method != Method::given;
    case CountsFor::candidates:
      return selects_candidates(settings.method);
    case CountsFor::hold_requirements:
      return balanced || goal_of(settings) == Goal::hold;
    case CountsFor::balanced:
      return balanced;
    case CountsFor::given:
      return settings.method == Method::given;
  }
  return true;
}

bool is_kept(const SettingRow& row, const Settings& settings) {
  const bool is_theirs = row.counts_for == CountsFor::balanced ||
                         row.counts_for == CountsFor::hold_requirements ||
                         row.counts_for == CountsFor::given;
  return !is_theirs || counts(row.counts_for, settings);
}

std::string requirement(Setting setting) {
  const SettingRow& row = row_of(setting);
  if (!row.rule.empty()) return say("{subject} {rule}", {row.subject, row.rule});
  const bool unset = !row.range.unset.empty();
  const std::string values[] = {std::string(translated(row.subject)), row.access.kind(row.range),
                                std::string(row.range.unset)};
  return say_written(unset ? "{subject} must be {kind}, or {other}" : "{subject} must be {kind}",
                     values, unset ? 3 : 2);
}

InputError setting_error(Setting setting) { return setting_error(setting, requirement(setting)); }

InputError setting_error(Setting setting, std::string why) {
  return bad_setting(std::string(name(setting)), std::move(why));
}

std::optional<InputError> read_setting(Setting setting, std::string_view text, Document& document) {
  const SettingRow& row = row_of(setting);
  if (!row.access.read(text, row.range, document)) {
    const std::string_view part =
        row.access.refused ? row.access.refused(text) : std::string_view();
    if (part.empty()) return setting_error(setting);
    const std::string values[] = {requirement(setting), std::string(part)};
    return setting_error(setting, say_written("{requirement}, not \"{part}\"", values, 2));
  }
  if (row.changes == Changes::stands) document.moved = {};
  return std::nullopt;
}

std::string text_of(Setting setting, const Document& document) {
  const SettingRow& row = row_of(setting);
  return row.access.text(document, row.range);
}

bool alike(const Document& a, const Document& b, bool SettingRow::*column) {
  return std::all_of(std::begin(rows), std::end(rows), [&](const SettingRow& row) {
    return !(row.*column) || row.access.text(a, row.range) == row.access.text(b, row.range);
  });
}

std::optional<std::uint64_t> read_failed(std::string_view text) {
  if (text == "none") return 0;
  const std::optional<std::uint64_t> number = read_whole(text);
  return number && *number > 0 ? number : std::nullopt;
}

std::optional<InputError> check_ranges(const Settings& settings, const Shown& shown) {
  const Document document{{}, {}, settings, shown, {}};
  for (const SettingRow& row : rows)
    if (!row.access.allowed(document, row.range)) return setting_error(row.setting);
  return std::nullopt;
}

bool is_in_range(Setting setting, double value) {
  return setting_value::is_within(value, row_of(setting).range);
}

}  // namespace evenlift
