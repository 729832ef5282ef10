// The table of settings: their names, allowed values and meanings, and where they can be given. The
// program's options, JSON, share links, lessons, scripts, undo and the page's panels are made from
// the rows of this table. CONTRIBUTING.md describes how to add a row.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// The settings, in the order in which JSON lists them.
enum class Setting : std::uint8_t {
  teams,
  method,
  min_ratio,
  com,
  weight,
  seed,
  overlays,
  step,
  com_radius,
  capacity,
  robot,
  no_go,
  unit,
  weight_unit,
  goal,
  robots,
  positions,
  min_margin,
  apart,
  survive,
  clear,
  accuracy,
  robot_radius,
  robot_reach,
  robot_depth,
  robot_width,
  robot_gap,
  supports,
  snap,
  support_capacities,
  support_names,
  cargo,
  com_height,
  slope,
  acceleration,
  give,
  uneven,
  extra,
  readings,
  reading_error,
  level_error,
  readings_tilted,
  tilted,
  heading,
  dynamic,
  weight_doubt,
  loads,
  failed,
  end_of_settings  // not a setting: counts the settings, each of which needs a row; keep it last
};

// What changes when a setting changes.
enum class Changes : std::uint8_t {
  stands,  // where robots stand; read_setting() then discards moves by hand
  loads,   // the results of a placement, but not where robots stand
  shown,   // how a placement is shown or examined (Shown)
  view     // the page or program, not a document; read_setting() refuses such a setting
};

// The placements that a setting affects.
enum class CountsFor : std::uint8_t {
  all,
  placing,            // all methods but `given`
  candidates,         // methods that choose among candidates
  hold_requirements,  // balanced robots, and the goal `hold`
  balanced,
  given
};
// Whether `placements` include the placement of these settings. O(1).
bool counts(CountsFor placements, const Settings& settings);

// The groups of the program's options. The commands `place` and `link encode` accept all groups;
// `trace` and `optimum` accept only `placement`.
enum class OptionGroup : std::uint8_t { none, placement, uncertainty, units };

// When this table puts a setting into the JSON of a document or a result.
enum class Listed : std::uint8_t {
  never,       // but other code may put it there, as with `com`
  if_changed,  // if it is not the default
  always
};

// The allowed numbers, and the word that unsets the setting, if any.
struct SettingRange {
  double least = 0, most = 0;
  std::string_view unset = {};
};

struct SettingRow {
  Setting setting;
  std::string_view name;        // in JSON, scripts and requests, such as "min_ratio"
  std::string_view alias = {};  // a second name that is also read, if any
  std::string_view subject;     // such as "the minimum load ratio"
  std::string_view edit = {};   // what undo calls a change of the setting, or empty
  Changes changes = Changes::stands;
  CountsFor counts_for = CountsFor::all;
  SettingRange range = {};
  std::string_view rule = {};  // the requirement, if type and range do not determine it
  struct Option {
    OptionGroup group = OptionGroup::none;
    std::string_view value = {}, help = {};
  };
  Option option = {};          // the program's option; its name is also a key in lessons
  std::uint8_t record = 0;     // the number of its record (docs/link-format.md); 0 if it has none
  std::string_view json = {};  // the name of its JSON member, if that is not `name`
  Listed in_document = Listed::never, in_result = Listed::never;
  bool is_length = false;  // in the document's unit of length
  bool is_weight = false;  // in its unit of weight
  bool plans = true;       // whether the number of robots needed depends on it (capacity.h)
  bool told = true;  // of settings with Changes::shown: whether reports depend on it (report.h)

  // Reads and writes the member of a Document that holds the setting. `read` returns whether the
  // text is valid, and changes the document only if it is. `text` returns text that `read` accepts,
  // and is empty for a setting of the view. `allowed` returns whether the member is in its range.
  // `kind` describes the allowed values; it may be null if the row has a rule.
  struct Access {
    bool (*read)(std::string_view text, const SettingRange& range, Document& document);
    std::string (*text)(const Document& document, const SettingRange& range);
    bool (*allowed)(const Document& document, const SettingRange& range);
    std::string (*kind)(const SettingRange& range);
    bool is_number = false;  // whether the value is a number (or unset) rather than text
    bool is_whole = false;   // of numbers
    // The names of the values one after another, then an empty text; null if the values are no names.
    std::string_view (*names)(std::size_t i) = nullptr;
    // Returns the first wrong part of a list; empty if that part is too long to quote.
    std::string_view (*refused)(std::string_view text) = nullptr;
  };
  Access access = {};
};

// all_settings() returns all rows in the order of Setting; row_of() returns the row of one setting.
// O(1).
std::span<const SettingRow> all_settings();
const SettingRow& row_of(Setting setting);

// Whether two documents have the same values of all settings in whose rows this is true. O(settings).
bool alike(const Document& a, const Document& b, bool SettingRow::*column);

// Whether JSON and links include the setting. They omit a setting of balanced robots, of the goal
// `hold` or of supports if it has no effect with these `settings`. O(1).
bool is_kept(const SettingRow& row, const Settings& settings);

// name() returns the setting's name. setting_from_name() returns the setting with this name or
// alias; the result is empty if the name is unknown. O(1).
std::string_view name(Setting setting);
std::optional<Setting> setting_from_name(std::string_view text);

// The name in options and lessons, such as "min-ratio". O(1).
std::string hyphened(std::string_view name);

// The requirement on the value, as a sentence without a full stop: "the minimum load ratio must be
// a number from 0 to 1". O(1).
std::string requirement(Setting setting);

// The error for an invalid value. Its code is bad_setting, its message is the requirement or `why`,
// and its place is the setting.
InputError setting_error(Setting setting);
InputError setting_error(Setting setting, std::string why);

// Sets a setting from text, such as "0.8", "max" or "3,5:0.25-0.75". Numbers have the syntax of
// read_number(), and whole numbers that of read_whole(); a slope may also end in %, deg or °, and an
// acceleration in g or m/s2. Only the
// comma of `com` may have spaces and tabs around it. Any other text or value (see requirement()) is
// an error and changes nothing. The error for `no_go`, `supports` or `cargo` quotes the first wrong
// part if that part is short. `supports` also replaces the capacities by those that follow an @, as
// in "0,0@30 160,0". Unless its text is "none", it also sets the method `given`. O(bytes).
std::optional<InputError> read_setting(Setting setting, std::string_view text, Document& document);

// Text that read_setting() accepts. The text is empty for a setting of the view, and for an unset
// setting that has no word for "unset", such as `apart`. O(bytes).
std::string text_of(Setting setting, const Document& document);

// These values as text. Supports are like "0,0 160,0 80,90", and cargo is like "8,8:24
// 2,3:1.5:motor". O(bytes).
std::string robot_text(const RobotSize& robot);
std::string no_go_text(const std::vector<EdgePart>& no_go);
std::string supports_text(const Points& supports);
std::string cargo_text(const std::vector<Cargo>& cargo);

// An overlay, and its name in JSON and in the text of the setting `overlays`.
struct NamedOverlay {
  std::string_view name;
  bool Overlays::*shown;
};
std::span<const NamedOverlay> all_overlays();

// Robots moved by hand, as text. Each balanced robot is EDGE:PART, and each team is
// TEAM@EDGE:PART/EDGE. Numbers count from 1, parts are from 0 to 1, and commas separate robots or
// teams, as in "3:0.25,5:0.5,9:1" or "2@3:0.25/9". The text is empty if no robots were moved.
// read_moved() returns nothing for any other text, and for an empty text. O(bytes).
std::string moved_text(const Moved& moved);
std::optional<Moved> read_moved(std::string_view text);

// Whether `moved` has entries in at most one of its lists, numbers within their bounds, and teams
// in ascending order. O(robots).
bool is_moved(const Moved& moved);

// Reads the number of the failed robot, a whole number from 1. The result is 0 for the text "none",
// and empty for any other text. O(bytes).
std::optional<std::uint64_t> read_failed(std::string_view text);

// Checks that each setting is in its range. The error's place names the setting. check_settings()
// (placement.h) also checks that the settings are compatible.
// O(no-go parts + supports + items of cargo).
std::optional<InputError> check_ranges(const Settings& settings, const Shown& shown = {});

// Whether the value is in the range of a setting that is a single number. O(1).
bool is_in_range(Setting setting, double value);

}  // namespace evenlift
