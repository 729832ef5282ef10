#include "link/records.h"

#include <optional>
#include <string_view>

#include "evenlift/numbers.h"
#include "evenlift/settings_text.h"
#include "exact/bits.h"

namespace evenlift {
namespace {

// The values that a link of version 2 leaves out. They stay as they are even if the defaults of
// Settings change (test_link.cpp compares the two).
constexpr double usual_min_margin = 0.05;
constexpr std::uint32_t usual_survive = 0;
constexpr double usual_com_radius = 0;
constexpr Positions usual_positions = Positions::best;

// The payload of an overlay that is shown.
constexpr const char* shown = "shown";

std::optional<Setting> setting_of(Tag tag) {
  switch (tag) {
    case Tag::robots:
      return Setting::robots;
    case Tag::goal:
      return Setting::goal;
    case Tag::min_margin:
      return Setting::min_margin;
    case Tag::apart:
      return Setting::apart;
    case Tag::clear:
      return Setting::clear;
    case Tag::survive:
      return Setting::survive;
    case Tag::positions:
      return Setting::positions;
    case Tag::com_radius:
      return Setting::com_radius;
    case Tag::capacity:
      return Setting::capacity;
    case Tag::robot:
      return Setting::robot;
    case Tag::no_go:
      return Setting::no_go;
    default:
      return std::nullopt;
  }
}

// "mm", ",lb" or "mm,lb"; empty for the usual units, which need no record.
std::string units_text(const Units& units) {
  std::string text;
  if (units.length != LengthUnit::none) text += name(units.length);
  if (units.weight != WeightUnit::kg) text += "," + std::string(name(units.weight));
  return text;
}

// Whether the text is what units_text() writes of some units.
bool take_units(const std::string& text, Document& document) {
  document.settings.units = {};
  const std::size_t comma = text.find(',');
  if (comma != 0 && read_setting(Setting::unit, text.substr(0, comma), document)) return false;
  if (comma != std::string::npos &&
      read_setting(Setting::weight_unit, text.substr(comma + 1), document))
    return false;
  return !text.empty() && units_text(document.settings.units) == text;
}

void add_min_margin(Records& records, const Settings& settings) {
  if (!same_bits(settings.min_margin, usual_min_margin))
    records.push_back({Tag::min_margin, shortest(settings.min_margin)});
}

// What only balanced robots have.
void add_balanced(Records& records, const Settings& settings) {
  records.push_back({Tag::robots, std::to_string(settings.robots)});
  if (settings.goal) records.push_back({Tag::goal, std::string(name(*settings.goal))});
  add_min_margin(records, settings);
  if (settings.apart) records.push_back({Tag::apart, shortest(*settings.apart)});
  if (settings.survive != usual_survive)
    records.push_back({Tag::survive, std::to_string(settings.survive)});
}

// The usual goal of teams of two is to cover.
void add_goal_of_teams(Records& records, const Settings& settings) {
  if (settings.goal != Goal::hold) return;
  records.push_back({Tag::goal, std::string(name(Goal::hold))});
  add_min_margin(records, settings);
}

// Whether robots were moved that the method places.
bool has_moved(const Document& document) {
  const Moved& moved = document.moved;
  return document.settings.method == Method::balanced ? !moved.robots.empty()
                                                      : !moved.teams.empty();
}

// Takes a number that was not bounded when links could hold it first: see check_linked_settings().
bool take_unbounded(Tag tag, const std::string& text, Settings& settings) {
  const std::optional<double> value = read_number(text);
  if (!value || *value < 0) return false;
  if (tag == Tag::apart)
    settings.apart = *value;
  else if (tag == Tag::capacity && *value > 0)
    settings.capacity = *value;
  else if (tag == Tag::com_radius)
    settings.com_radius = *value;
  else
    return false;
  return true;
}

bool take_moved(const std::string& text, Document& document) {
  auto moved = read_moved(text);
  if (!moved) return false;
  document.moved = *std::move(moved);
  return true;
}

}  // namespace

bool is_known(Tag tag) {
  return tag == Tag::halo || tag == Tag::units || tag == Tag::moved || setting_of(tag).has_value();
}

Records records_of(const Document& document) {
  const Settings& settings = document.settings;
  Records records;
  if (settings.method == Method::balanced)
    add_balanced(records, settings);
  else
    add_goal_of_teams(records, settings);
  if (settings.positions != usual_positions)
    records.push_back({Tag::positions, std::string(name(settings.positions))});
  if (!same_bits(settings.com_radius, usual_com_radius))
    records.push_back({Tag::com_radius, shortest(settings.com_radius)});
  if (settings.capacity) records.push_back({Tag::capacity, shortest(*settings.capacity)});
  if (settings.robot != RobotSize{}) records.push_back({Tag::robot, robot_text(settings.robot)});
  if (!settings.no_go.empty()) records.push_back({Tag::no_go, no_go_text(settings.no_go)});
  if (!(settings.units == Units{})) records.push_back({Tag::units, units_text(settings.units)});
  if (settings.overlays.halo) records.push_back({Tag::halo, shown});
  if (has_moved(document)) records.push_back({Tag::moved, moved_text(document.moved)});
  if (settings.clear) records.push_back({Tag::clear, shortest(*settings.clear)});
  return records;
}

bool take_records(const Records& records, Document& document) {
  document.settings.min_margin = usual_min_margin;
  document.settings.survive = usual_survive;
  document.settings.com_radius = usual_com_radius;
  document.settings.units = {};
  document.settings.positions = usual_positions;
  for (const Record& record : records) {
    if (record.tag == Tag::halo) {
      if (record.payload != shown) return false;
      document.settings.overlays.halo = true;
      continue;
    }
    if (record.tag == Tag::units || record.tag == Tag::moved) {
      const bool units = record.tag == Tag::units;
      if (!(units ? take_units(record.payload, document) : take_moved(record.payload, document)))
        return false;
      continue;
    }
    if (record.tag == Tag::robots) document.settings.method = Method::balanced;
    if (take_unbounded(record.tag, record.payload, document.settings)) continue;
    if (read_setting(*setting_of(record.tag), record.payload, document)) return false;
  }
  return true;
}

}  // namespace evenlift
