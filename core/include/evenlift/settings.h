// The table of settings: their names, allowed values and meanings, and where they can be given. The
// program's options, JSON, share links, lessons, scripts, undo and the page's panels are made from
// its rows. CONTRIBUTING.md describes how to add one.
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
  robot_radius,
  robot_reach,
  robot_depth,
  robot_width,
  robot_gap,
  supports,
  snap,
  support_capacities,
  cargo,
  com_height,
  slope,
  acceleration,
  give,
  uneven,
  extra,
  loads,
  failed,
  end_of_settings  // not a setting; keep it last: it counts the settings, and each needs a row
};

// The effect of changing a setting.
enum class Changes : std::uint8_t {
  stands,  // where robots stand; discards moves by hand
  loads,   // the results of a placement, but not where robots stand
  shown,   // how a placement is shown or examined (Shown)
  view     // the page or program, not a document; read_setting() refuses it
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
// Whether `placements` include that of these settings. O(1).
bool counts(CountsFor placements, const Settings& settings);

// The groups of the program's options. `place` and `link encode` accept all of them; `trace` and
// `optimum` accept only those of `placement`.
enum class OptionGroup : std::uint8_t { none, placement, uncertainty, units };

// How JSON lists a setting in a document or a result.
enum class Listed : std::uint8_t {
  never,       // but a result that depends on it may contain it
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
  std::string_view subject;     // "the minimum load ratio"
  std::string_view edit = {};   // the name of this change in undo, or empty
  Changes changes = Changes::stands;
  CountsFor counts_for = CountsFor::all;
  SettingRange range = {};
  std::string_view rule = {};  // the requirement, if type and range do not determine it
  struct Option {
    OptionGroup group = OptionGroup::none;
    std::string_view value = {}, help = {};
  };
  Option option = {};          // the option of the program; also a key of lessons, of the same name
  std::uint8_t record = 0;     // the number of its record in share links; 0 without one
  std::string_view json = {};  // the name of its JSON member, if different
  Listed in_document = Listed::never, in_result = Listed::never;
  bool is_length = false;  // in the document's unit of length

  // Reads and writes the member of a Document that holds the setting. `read` returns whether the
  // text is valid, and only then changes the document. `text` returns text that `read` accepts.
  struct Access {
    bool (*read)(std::string_view text, const SettingRange& range, Document& document);
    std::string (*text)(const Document& document, const SettingRange& range);
    bool (*allowed)(const Document& document, const SettingRange& range);
    std::string (*kind)(const SettingRange& range);
    bool is_number = false;  // a number or unset; otherwise a word
    // Returns the first wrong part of a list; empty if it is too long to quote.
    std::string_view (*refused)(std::string_view text) = nullptr;
  };
  Access access = {};
};

// All rows in the order of Setting; and the row of one setting. O(1).
std::span<const SettingRow> all_settings();
const SettingRow& row_of(Setting setting);

// Whether JSON and links include the setting, given the other settings. They omit a setting of
// balanced robots, the goal `hold` or supports if it has no effect. O(1).
bool is_kept(const SettingRow& row, const Settings& settings);

// The setting's name; and the setting with a name or alias, empty if it is unknown. O(1).
std::string_view name(Setting setting);
std::optional<Setting> setting_from_name(std::string_view text);

// The name in options and lessons, such as "min-ratio". O(1).
std::string hyphened(std::string_view name);

// The requirement on the value, as a sentence without a full stop: "the minimum load ratio must be
// a number from 0 to 1". O(1).
std::string requirement(Setting setting);

// The error for an invalid value: code bad_setting, the requirement or another reason, and the
// setting as the place.
InputError setting_error(Setting setting);
InputError setting_error(Setting setting, std::string why);

// Sets a setting from text, such as "0.8", "max" or "3,5:0.25-0.75". Numbers have the syntax of
// read_number(), whole numbers that of read_whole(). Only the comma of `com` may have spaces and
// tabs around it. Any other text or value (see requirement()) is an error and changes nothing. The
// error for `no_go`, `supports` or `cargo` quotes the first wrong part if it is short. A setting
// that changes where robots stand discards moves by hand. `supports` also sets the method `given`,
// and the capacities that follow an @, such as "0,0@30 160,0". O(bytes).
std::optional<InputError> read_setting(Setting setting, std::string_view text, Document& document);

// Text that read_setting() accepts; empty if the setting is not set and, like `apart`, has no word
// for that. O(bytes).
std::string text_of(Setting setting, const Document& document);

// These values as text; supports are "0,0 160,0 80,90" and cargo "8,8:24 2,3:1.5:motor". O(bytes).
std::string robot_text(const RobotSize& robot);
std::string no_go_text(const std::vector<EdgePart>& no_go);
std::string supports_text(const Points& supports);
std::string cargo_text(const std::vector<Cargo>& cargo);

// An overlay with its name in JSON and texts.
struct NamedOverlay {
  std::string_view name;
  bool Overlays::*shown;
};
std::span<const NamedOverlay> all_overlays();

// Robots moved by hand, as text: each balanced robot as EDGE:PART, each team as
// TEAM@EDGE:PART/EDGE, with numbers from 1, parts from 0 to 1, and commas between them, such as
// "3:0.25,5:0.5,9:1" or "2@3:0.25/9". The text is empty if no robots were moved. The result of
// read_moved() is empty for any other text. O(bytes).
std::string moved_text(const Moved& moved);
std::optional<Moved> read_moved(std::string_view text);

// Whether the numbers of `moved` are within their bounds, and its teams in ascending order.
// O(robots).
bool is_moved(const Moved& moved);

// The number of the failed robot: a whole number from 1, or 0 for "none". The result is empty for
// any other text. O(bytes).
std::optional<std::uint64_t> read_failed(std::string_view text);

// Checks that each setting is in its range. The error's place names the setting. check_settings()
// (placement.h) also checks that they are compatible. O(parts of no_go).
std::optional<InputError> check_ranges(const Settings& settings, const Shown& shown = {});

// Whether the value is in the range of a setting that is a single number. O(1).
bool is_in_range(Setting setting, double value);

}  // namespace evenlift
