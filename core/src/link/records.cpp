#include "link/records.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "exact/sorted_indices.h"
#include "link/settings.h"

namespace evenlift {
namespace {

// Each item has three numbers, and a name in quotes with characters of up to four bytes.
constexpr std::size_t most_bytes_of_cargo = max_cargo * (3 * 26 + 4 * max_name_characters + 4);
static_assert(most_bytes_of_cargo < 1u << widest_length);

// Overlays added after version 1, and the payload of one that is shown.
struct OverlayRecord {
  Tag tag;
  bool Overlays::*overlay;
};
constexpr OverlayRecord overlay_records[] = {
    {tag::halo, &Overlays::halo}, {tag::tilt, &Overlays::tilt}, {tag::load, &Overlays::load}};
constexpr const char* shown = "shown";

const OverlayRecord* overlay_of_record(Tag number) {
  for (const OverlayRecord& record : overlay_records)
    if (record.tag == number) return &record;
  return nullptr;
}

const SettingRow* row_of_record(Tag number) {
  for (const SettingRow& row : all_settings())
    if (row.record == number && number != tag::end) return &row;
  return nullptr;
}

// A record of the number of robots means balanced robots, and one of supports given robots. The
// default goal of teams is `cover`.
bool is_needed(const SettingRow& row, const Document& document, const Document& defaults) {
  const Settings& settings = document.settings;
  if (!is_kept(row, settings)) return false;
  if (row.setting == Setting::robots || row.setting == Setting::supports) return true;
  if (row.setting == Setting::goal && settings.method != Method::balanced)
    return settings.goal == Goal::hold;
  return text_of(row.setting, document) != text_of(row.setting, defaults);
}

// "mm", ",lb" or "mm,lb"; empty for the default units, which need no record.
std::string units_text(const Units& units) {
  std::string text;
  if (units.length != LengthUnit::none) text += name(units.length);
  if (units.weight != WeightUnit::kg) text += "," + std::string(name(units.weight));
  return text;
}

// Returns whether units_text() could have written the text.
bool take_units(const std::string& text, Document& document) {
  document.shown.units = {};
  const std::size_t comma = text.find(',');
  if (comma != 0 && read_setting(Setting::unit, text.substr(0, comma), document)) return false;
  if (comma != std::string::npos &&
      read_setting(Setting::weight_unit, text.substr(comma + 1), document))
    return false;
  return !text.empty() && units_text(document.shown.units) == text;
}

// Counts only robots of the document's method.
bool has_moved(const Document& document) {
  const Moved& moved = document.moved;
  return document.settings.method == Method::balanced ? !moved.robots.empty()
                                                      : !moved.teams.empty();
}

// Early links had no bounds here: see check_linked_settings().
bool take_unbounded(Setting setting, const std::string& text, Document& document) {
  const std::optional<double> value = read_number(text);
  if (!value || *value < 0) return false;
  if (setting == Setting::apart)
    document.settings.apart = *value;
  else if (setting == Setting::capacity && *value > 0)
    document.shown.capacity = *value;
  else if (setting == Setting::com_radius)
    document.shown.com_radius = *value;
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

bool is_known(Tag number) {
  return number == tag::holes || number == tag::units || number == tag::moved ||
         overlay_of_record(number) || row_of_record(number);
}

std::size_t longest_value(Tag number) {
  if (number == tag::moved) return 64 * most_moved_teams;
  const SettingRow* row = row_of_record(number);
  if (row && row->setting == Setting::robot) return 5 * 32;
  if (row && row->setting == Setting::support_capacities) return 32 * most_supports;
  if (row && row->setting == Setting::cargo) return most_bytes_of_cargo;
  return row && row->setting == Setting::no_go ? 64 * most_no_go : 32;
}

Records records_of(const Document& document) {
  const Document defaults = defaults_of_links();
  Records records;
  for (const SettingRow& row : all_settings())
    if (row.record != tag::end && is_needed(row, document, defaults))
      records.push_back({row.record, row.record == tag::supports ? std::string()
                                                                 : text_of(row.setting, document)});
  const Shown& asked = document.shown;
  if (!document.holes.empty()) records.push_back({tag::holes, {}});
  if (!(asked.units == Units{})) records.push_back({tag::units, units_text(asked.units)});
  for (const auto& [number, overlay] : overlay_records)
    if (asked.overlays.*overlay) records.push_back({number, shown});
  if (has_moved(document)) records.push_back({tag::moved, moved_text(document.moved)});
  sort_items(records, [](const Record& a, const Record& b) { return a.tag < b.tag; });
  return records;
}

bool take_records(const Records& records, Document& document) {
  for (const auto& [number, payload] : records) {
    if (const OverlayRecord* record = overlay_of_record(number)) {
      if (payload != shown) return false;
      document.shown.overlays.*record->overlay = true;
    } else if (number == tag::units) {
      if (!take_units(payload, document)) return false;
    } else if (number == tag::moved) {
      if (!take_moved(payload, document)) return false;
    } else if (number == tag::supports) {
      document.settings.method = Method::given;
    } else if (number == tag::holes) {
      continue;  // coded like vertices
    } else {
      const Setting setting = row_of_record(number)->setting;
      if (setting == Setting::robots) document.settings.method = Method::balanced;
      if (take_unbounded(setting, payload, document)) continue;
      if (read_setting(setting, payload, document)) return false;
    }
  }
  return true;
}

}  // namespace evenlift
