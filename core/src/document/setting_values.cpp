// Values with their own syntax.
#include "document/setting_values.h"

#include <algorithm>
#include <cmath>

#include "document/cargo_settings.h"
#include "document/stand_settings.h"
#include "document/support_settings.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr NamedOverlay overlay_names[] = {
    {"candidates", &Overlays::candidates},
    {"chords", &Overlays::chords},
    {"hull", &Overlays::lifting_base},
    {"clockwise", &Overlays::clockwise},
    {"counterclockwise", &Overlays::counterclockwise},
    {"tipping", &Overlays::tipping},
    {"halo", &Overlays::halo},
    {"tilt", &Overlays::tilt},
    {"load", &Overlays::load},
};

}  // namespace

std::span<const NamedOverlay> all_overlays() { return overlay_names; }

namespace setting_value {

bool take(std::string_view text, const SettingRange&, std::optional<Vec2>& centre) {
  if (text == "centroid") {
    centre.reset();
    return true;
  }
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return false;
  const std::string_view before = text.substr(0, comma), after = text.substr(comma + 1);
  // Spaces may surround the comma, but not the whole text.
  if (trimmed(before).data() != before.data() || trimmed(text).size() != text.size()) return false;
  const std::optional<double> x = read_number(trimmed(before)), y = read_number(trimmed(after));
  if (!x || !y) return false;
  centre = Vec2(*x, *y);
  return true;
}

std::string text_of(const std::optional<Vec2>& centre, const SettingRange&) {
  return centre ? shortest(centre->x) + "," + shortest(centre->y) : "centroid";
}

// The size of the numbers is checked together with the vertices.
bool is_within(const std::optional<Vec2>&, const SettingRange&) { return true; }

bool take(std::string_view text, const SettingRange&, Overlays& overlays) {
  Overlays shown;
  for (const NamedOverlay& overlay : overlay_names) shown.*(overlay.shown) = false;
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
  overlays = shown;
  return true;
}

std::string text_of(const Overlays& overlays, const SettingRange&) {
  std::string text;
  for (const NamedOverlay& overlay : overlay_names)
    if (overlays.*(overlay.shown)) text += (text.empty() ? "" : ",") + std::string(overlay.name);
  return text.empty() ? "none" : text;
}

bool is_within(const Overlays&, const SettingRange&) { return true; }

bool take(std::string_view text, const SettingRange&, RobotSize& robot) {
  return read_robot(text, robot);
}
std::string text_of(const RobotSize& robot, const SettingRange&) { return robot_text(robot); }
bool is_within(const RobotSize& robot, const SettingRange&) { return is_robot_size(robot); }

bool take(std::string_view text, const SettingRange&, std::vector<EdgePart>& no_go) {
  return read_no_go(text, no_go);
}
std::string text_of(const std::vector<EdgePart>& no_go, const SettingRange&) {
  return no_go_text(no_go);
}
bool is_within(const std::vector<EdgePart>& no_go, const SettingRange&) { return is_no_go(no_go); }

bool take(std::string_view text, const SettingRange&, Points& supports) {
  Document read;
  if (!read_supports(text, read)) return false;
  supports = std::move(read.settings.supports);
  return true;
}
std::string text_of(const Points& supports, const SettingRange&) { return supports_text(supports); }
bool is_within(const Points& supports, const SettingRange&) {
  const auto is_bounded = [](const Vec2& at) {
    return std::fabs(at.x) <= max_coordinate && std::fabs(at.y) <= max_coordinate;
  };
  return supports.size() <= most_supports &&
         std::all_of(supports.begin(), supports.end(), is_bounded);
}

bool take(std::string_view text, const SettingRange&, Capacities& capacities) {
  return read_capacities(text, capacities);
}
std::string text_of(const Capacities& capacities, const SettingRange&) {
  return capacities_text(capacities);
}
bool is_within(const Capacities& capacities, const SettingRange&) {
  return are_capacities(capacities);
}

bool take(std::string_view text, const SettingRange&, CargoList& cargo) {
  return read_cargo(text, cargo);
}
std::string text_of(const CargoList& cargo, const SettingRange&) { return cargo_text(cargo); }
bool is_within(const CargoList& cargo, const SettingRange&) { return is_cargo(cargo); }

}  // namespace setting_value

}  // namespace evenlift
