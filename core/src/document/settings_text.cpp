#include "evenlift/settings_text.h"

#include <iterator>

#include "document/stand_settings.h"
#include "evenlift/numbers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

struct NamedOverlay {
  std::string_view name;
  bool Overlays::*shown;
};
constexpr NamedOverlay overlay_names[] = {
    {"candidates", &Overlays::candidates},
    {"chords", &Overlays::chords},
    {"hull", &Overlays::lifting_base},
    {"clockwise", &Overlays::clockwise},
    {"counterclockwise", &Overlays::counterclockwise},
    {"tipping", &Overlays::tipping},
    {"halo", &Overlays::halo},
};

std::optional<std::uint32_t> read_whole_32(std::string_view text) {
  const std::optional<std::uint64_t> value = read_whole(text);
  if (!value || *value > ~std::uint32_t{0}) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

bool is_team_count(std::uint32_t value) { return value >= 1 && value <= max_teams; }

bool is_robot_count(std::uint32_t value) { return value >= least_robots && value <= most_robots; }

bool is_min_margin(double value) { return value >= 0 && value <= 1; }

bool is_survived(std::uint32_t value) { return value <= most_survived; }

// --- Readers: each returns whether the text is a value of its setting, and changes the setting only
// then.

template <auto member, bool (*is_allowed)(double)>
bool read_number_of(std::string_view text, Document& document) {
  const std::optional<double> value = read_number(text);
  if (!value || !is_allowed(*value)) return false;
  document.settings.*member = *value;
  return true;
}

template <auto member, bool (*is_allowed)(std::uint32_t)>
bool read_whole_of(std::string_view text, Document& document) {
  const std::optional<std::uint32_t> value = read_whole_32(text);
  if (!value || !is_allowed(*value)) return false;
  document.settings.*member = *value;
  return true;
}

template <auto member, auto from_name>
bool read_named(std::string_view text, Document& document) {
  const auto value = from_name(text);
  if (value) document.settings.*member = *value;
  return value.has_value();
}

template <double RobotSize::*part>
bool read_part_of_robot(std::string_view text, Document& document) {
  return read_size(text, document.settings.robot.*part);
}

// One of several values, by its name.
template <class Value, std::size_t n>
bool read_name(std::string_view text, const Value (&all)[n], Value& value) {
  for (const Value each : all) {
    if (text != name(each)) continue;
    value = each;
    return true;
  }
  return false;
}

bool read_nothing(std::string_view, Document&) { return false; }

bool read_teams(std::string_view text, Document& document) {
  const std::optional<std::uint32_t> teams = read_whole_32(text);
  if (teams ? !is_team_count(*teams) : text != "max") return false;
  document.settings.teams = teams;
  return true;
}

bool read_com(std::string_view text, Document& document) {
  if (text == "centroid") {
    document.centre_of_mass.reset();
    return true;
  }
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return false;
  const std::string_view before = text.substr(0, comma), after = text.substr(comma + 1);
  // Spaces may surround the comma, but not the whole text.
  if (trimmed(before).data() != before.data() || trimmed(text).size() != text.size()) return false;
  const std::optional<double> x = read_number(trimmed(before)), y = read_number(trimmed(after));
  if (!x || !y) return false;
  document.centre_of_mass = Vec2(*x, *y);
  return true;
}

bool read_seed(std::string_view text, Document& document) {
  const std::optional<std::uint64_t> value = read_whole(text);
  if (value) document.settings.seed = *value;
  return value.has_value();
}

bool read_overlays(std::string_view text, Document& document) {
  Overlays shown{false, false, false, false, false, false, false};
  while (text != "none") {
    const std::string_view word = text.substr(0, text.find(','));
    const NamedOverlay* found = nullptr;
    for (const NamedOverlay& overlay : overlay_names)
      if (overlay.name == word) found = &overlay;
    if (!found || shown.*(found->shown)) return false;  // unknown or repeated
    shown.*(found->shown) = true;
    if (word.size() == text.size()) break;
    text.remove_prefix(word.size() + 1);
    if (text == "none") return false;
  }
  document.settings.overlays = shown;
  return true;
}

bool read_step(std::string_view text, Document& document) {
  const std::optional<std::uint32_t> step = read_whole_32(text);
  if (!step && text != "none") return false;
  document.settings.step = step;
  return true;
}

bool read_capacity(std::string_view text, Document& document) {
  const std::optional<double> value = read_number(text);
  if (value ? !is_weight(*value) : text != "none") return false;
  document.settings.capacity = value;
  return true;
}

bool read_unit(std::string_view text, Document& document) {
  return read_name(text, all_length_units, document.settings.units.length);
}

bool read_weight_unit(std::string_view text, Document& document) {
  return read_name(text, all_weight_units, document.settings.units.weight);
}

bool read_whole_robot(std::string_view text, Document& document) {
  return read_robot(text, document.settings.robot);
}

bool read_parts(std::string_view text, Document& document) {
  return read_no_go(text, document.settings.no_go);
}

// --- The table

// Settings that say where robots stand put those that were moved by hand back; the others keep them.
constexpr bool places = true, keeps = false;

struct Entry {
  Setting setting;
  bool (*read)(std::string_view text, Document& document);
  bool places_robots;
  std::string_view name;
  const char* requirement;
};
constexpr Entry entries[] = {
    {Setting::teams, read_teams, places, "teams",
     "the number of teams is a whole number from 1 to 1048576, or max"},
    {Setting::method, read_named<&Settings::method, method_from_name>, places, "metric",
     "the metric is area, circle, distance, distributed, random or balanced"},
    {Setting::min_ratio, read_number_of<&Settings::min_ratio, is_min_ratio>, places, "min_ratio",
     "the minimum load ratio is a number from 0 to 1"},
    {Setting::com, read_com, places, "com", "the centre of mass is two numbers X,Y, or centroid"},
    {Setting::weight, read_number_of<&Settings::weight, is_weight>, keeps, "weight",
     "the weight is a number greater than 0, from 1e-100 to 1e100"},
    {Setting::seed, read_seed, places, "seed",
     "the seed is a whole number from 0 to 18446744073709551615"},
    {Setting::overlays, read_overlays, keeps, "overlays",
     "the overlays are none, or some of candidates, chords, hull, clockwise, counterclockwise, tipping and halo"},
    {Setting::step, read_step, keeps, "step",
     "the step is a whole number from 0 to 4294967295, or none"},
    {Setting::capacity, read_capacity, keeps, "capacity",
     "the capacity of a robot is a number greater than 0, from 1e-100 to 1e100, or none"},
    {Setting::com_radius, read_number_of<&Settings::com_radius, is_length>, keeps, "com_radius",
     "the radius within which the centre of mass is known is a number from 0 to 1000000000"},
    {Setting::loads, read_nothing, keeps, "loads",
     "the loads are those of plan, springs, best or worst"},
    {Setting::failed, read_nothing, keeps, "failed",
     "the robot that fails is its number, a whole number from 1, or none"},
    {Setting::robots, read_whole_of<&Settings::robots, is_robot_count>, places, "robots",
     "the number of robots is a whole number from 2 to 64"},
    {Setting::goal, read_named<&Settings::goal, goal_from_name>, places, "goal",
     "the goal is cover or hold"},
    {Setting::min_margin, read_number_of<&Settings::min_margin, is_min_margin>, places,
     "min_margin", "the margin of a firm hold is a number from 0 to 1"},
    {Setting::apart, read_number_of<&Settings::apart, is_length>, places, "apart",
     "the distance that parts robots is a number from 0 to 1000000000"},
    {Setting::survive, read_whole_of<&Settings::survive, is_survived>, places, "survive",
     "the number of failures to survive is a whole number from 0 to 30"},
    {Setting::unit, read_unit, keeps, "unit", "the unit of lengths is m, cm, mm or in, or none"},
    {Setting::weight_unit, read_weight_unit, keeps, "weight_unit",
     "the unit of weights is kg, t, N or lb"},
    {Setting::positions, read_named<&Settings::positions, positions_from_name>, places, "positions",
     "the positions are best or range"},
    {Setting::robot, read_whole_robot, places, "robot",
     "the size of a robot is none, or some of r, reach, depth, width and gap with numbers from 0 to 1000000000, such as r=30,reach=5"},
    {Setting::no_go, read_parts, places, "no_go",
     "the edges that must not be touched are none, or at most 1000 edges from 1 or parts of them from 0 to 1, such as 3,5:0.25-0.75"},
    {Setting::robot_radius, read_part_of_robot<&RobotSize::radius>, places, "robot_radius",
     "the radius of a robot is a number from 0 to 1000000000"},
    {Setting::robot_reach, read_part_of_robot<&RobotSize::reach>, places, "robot_reach",
     "the reach of a robot's arm is a number from 0 to 1000000000"},
    {Setting::robot_depth, read_part_of_robot<&RobotSize::depth>, places, "robot_depth",
     "the depth of a robot's hand is a number from 0 to 1000000000"},
    {Setting::robot_width, read_part_of_robot<&RobotSize::width>, places, "robot_width",
     "the width of a robot's hand is a number from 0 to 1000000000"},
    {Setting::robot_gap, read_part_of_robot<&RobotSize::gap>, places, "robot_gap",
     "the gap between robots is a number from 0 to 1000000000"},
    {Setting::clear, read_number_of<&Settings::clear, is_length>, places, "clear",
     "the distance that is not relied on is a number from 0 to 1000000000"},
};
static_assert(most_no_go == 1000);
static_assert(max_teams == 1048576);
static_assert(max_length == 1000000000 && max_weight == 1e100 && min_weight == 1e-100);
static_assert(least_robots == 2 && most_robots == 64 && most_survived == 30);

constexpr bool in_order() {
  for (std::size_t i = 0; i < std::size(entries); ++i)
    if (entries[i].setting != static_cast<Setting>(i)) return false;
  return std::size(entries) == static_cast<std::size_t>(Setting::end_of_settings);
}
static_assert(in_order(), "entry() finds a setting by its number");

const Entry& entry(Setting setting) { return entries[static_cast<std::size_t>(setting)]; }

}  // namespace

std::string_view name(Setting setting) { return entry(setting).name; }

std::optional<Setting> setting_from_name(std::string_view text) {
  for (const Entry& known : entries)
    if (known.name == text) return known.setting;
  return std::nullopt;
}

const char* requirement(Setting setting) { return entry(setting).requirement; }

InputError setting_error(Setting setting) { return setting_error(setting, requirement(setting)); }

InputError setting_error(Setting setting, std::string why) {
  return bad_setting(std::string(name(setting)), std::move(why));
}

std::optional<InputError> read_setting(Setting setting, std::string_view text, Document& document) {
  if (!entry(setting).read(text, document)) {
    const std::string_view part = setting == Setting::no_go ? refused_part(text) : "";
    if (part.empty()) return setting_error(setting);
    return setting_error(setting, requirement(setting) + (", not \"" + std::string(part) + "\""));
  }
  if (entry(setting).places_robots) document.moved = {};
  return std::nullopt;
}

std::optional<std::uint64_t> read_failed(std::string_view text) {
  if (text == "none") return 0;
  const std::optional<std::uint64_t> number = read_whole(text);
  return number && *number > 0 ? number : std::nullopt;
}

std::optional<InputError> check_ranges(const Settings& settings) {
  if (settings.teams && !is_team_count(*settings.teams)) return setting_error(Setting::teams);
  if (name(settings.method).empty()) return setting_error(Setting::method);
  if (!is_min_ratio(settings.min_ratio)) return setting_error(Setting::min_ratio);
  if (!is_weight(settings.weight)) return setting_error(Setting::weight);
  if (!is_robot_count(settings.robots)) return setting_error(Setting::robots);
  if (!is_min_margin(settings.min_margin)) return setting_error(Setting::min_margin);
  if (settings.apart && !is_length(*settings.apart)) return setting_error(Setting::apart);
  if (settings.clear && !is_length(*settings.clear)) return setting_error(Setting::clear);
  if (!is_survived(settings.survive)) return setting_error(Setting::survive);
  if (!is_length(settings.com_radius)) return setting_error(Setting::com_radius);
  if (!is_robot_size(settings.robot)) return setting_error(Setting::robot);
  if (!is_no_go(settings.no_go)) return setting_error(Setting::no_go);
  if (settings.capacity && !is_weight(*settings.capacity)) return setting_error(Setting::capacity);
  if (name(settings.units.length).empty()) return setting_error(Setting::unit);
  if (name(settings.units.weight).empty()) return setting_error(Setting::weight_unit);
  return std::nullopt;
}

bool is_min_ratio(double value) { return value >= 0 && value <= 1; }

bool is_weight(double value) { return value >= min_weight && value <= max_weight; }

bool is_length(double value) { return value >= 0 && value <= max_length; }

}  // namespace evenlift
