// Settings: the one table of what each is called, what it may be, what it means, and where it can
// be given. The program's options, JSON both ways, share links, lessons, scripts, undo and the
// page's panels are made from its rows, so a new setting needs a member (document.h), a row
// (core/src/document/settings.cpp) and, if people type it in the page, a row of a panel.
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

// In the order in which JSON lists them.
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
  loads,
  failed,
  end_of_settings  // no setting: it stays the last and counts them, so that each needs its row
};

// What a setting changes.
enum class Changes : std::uint8_t {
  stands,  // where robots stand: those that somebody moved by hand go back
  loads,   // what a placement says, but not where robots stand
  shown,   // what is shown of a placement or asked about it (Shown): no placement knows it
  view     // what the page and the program keep outside of a document: read_setting() refuses it
};

// The placements for which a setting counts.
enum class CountsFor : std::uint8_t { all, candidates, firm_hold, balanced };
bool counts(CountsFor placements, const Settings& settings);  // O(1)

// The options of the program by the commands that have them: `place`, `trace`, `optimum` and `link
// encode` have those of a placement; `place` and `link encode` have all.
enum class OptionGroup : std::uint8_t { none, placement, doubt, units };

// How JSON lists a setting of a document, and of a result.
enum class Listed : std::uint8_t {
  never,       // or at a place of its own, within what was found out about it
  if_changed,  // where it is not the usual value
  always
};

// The numbers that a setting may be, and the word that takes it back to nothing, if one does.
struct SettingRange {
  double least = 0, most = 0;
  std::string_view unset = {};
};

struct SettingRow {
  Setting setting;
  std::string_view name;       // in JSON, scripts and requests, such as "min_ratio"
  std::string_view subject;    // "the minimum load ratio"
  std::string_view edit = {};  // what undo says was changed, if it tells it from others
  Changes changes = Changes::stands;
  CountsFor counts_for = CountsFor::all;
  SettingRange range = {};
  std::string_view rule = {};  // what it must be, where its type and range do not tell
  struct Option {
    OptionGroup group = OptionGroup::none;
    std::string_view value = {}, help = {};
  };
  Option option = {};          // of the program; lessons have it as a key, with the same name
  std::uint8_t record = 0;     // the number of its record in share links; 0: none
  std::string_view json = {};  // its member, if that has another name
  Listed in_document = Listed::never, in_result = Listed::never;
  bool is_length = false;  // in the document's unit of length

  // What its member in a Document is, as functions. `read` returns whether the text is a value, and
  // changes the document only then; `text` is what `read` takes.
  struct Access {
    bool (*read)(std::string_view text, const SettingRange& range, Document& document);
    std::string (*text)(const Document& document, const SettingRange& range);
    bool (*allowed)(const Document& document, const SettingRange& range);
    std::string (*kind)(const SettingRange& range);
    bool is_number = false;  // or nothing; otherwise it is a word
  };
  Access access = {};
};

// All settings in the order of Setting, and the row of one. O(1).
std::span<const SettingRow> all_settings();
const SettingRow& row_of(Setting setting);

// Whether JSON and links hold the setting with these others: what only balanced robots and firm
// holds have is left out where there are none. O(1).
bool is_kept(const SettingRow& row, const Settings& settings);

// The setting's name; and the setting of a name, or nothing for an unknown name. O(1).
std::string_view name(Setting setting);
std::optional<Setting> setting_from_name(std::string_view text);

// The name as options and lessons have it, such as "min-ratio". O(1).
std::string hyphened(std::string_view name);

// A sentence that says what the setting's value must be, without a full stop, such as "the minimum
// load ratio is a number from 0 to 1". O(1).
std::string requirement(Setting setting);

// The error for a bad value: code bad_setting, the requirement or another reason, and a place that
// names the setting.
InputError setting_error(Setting setting);
InputError setting_error(Setting setting, std::string why);

// Sets a setting of the document from text, such as "0.8", "max" or "3,5:0.25-0.75"; requirement()
// says what each may be. Numbers have the syntax of read_number(), whole numbers that of
// read_whole(): no spaces and no hexadecimal. Only the comma of com may have spaces and tabs around
// it. Any other text, and any value out of range, is an error and changes nothing; of no_go the
// error quotes the first part that is wrong if it is short. A setting that changes where robots
// stand puts robots back that were moved by hand. O(bytes).
std::optional<InputError> read_setting(Setting setting, std::string_view text, Document& document);

// The setting's text as read_setting() takes it; empty for one that is not set and has no word for
// that, such as apart. O(bytes).
std::string text_of(Setting setting, const Document& document);

// The texts of two settings by themselves. O(bytes).
std::string robot_text(const RobotSize& robot);
std::string no_go_text(const std::vector<EdgePart>& no_go);

// The overlays by their names in JSON and texts.
struct NamedOverlay {
  std::string_view name;
  bool Overlays::*shown;
};
std::span<const NamedOverlay> all_overlays();

// Robots that were moved by hand, as text: each balanced robot as EDGE:PART, each team as
// TEAM@EDGE:PART/EDGE, with numbers from 1 and parts from 0 to 1, and commas between them, such as
// "3:0.25,5:0.5,9:1" or "2@3:0.25/9"; an empty text if there are none. read_moved() gives nothing
// for any other text. O(bytes).
std::string moved_text(const Moved& moved);
std::optional<Moved> read_moved(std::string_view text);

// Whether the numbers of moved robots are within their bounds, and teams in ascending order.
// O(robots).
bool is_moved(const Moved& moved);

// The number of the robot that fails, from 1, from text: a whole number, or "none", which is 0.
// O(bytes).
std::optional<std::uint64_t> read_failed(std::string_view text);

// Checks that each setting by itself is in its range. The error's place names the setting. Whether
// settings go together is checked by check_settings() (placement.h). O(parts of no_go).
std::optional<InputError> check_ranges(const Settings& settings, const Shown& shown = {});

// Whether a value is in the range of a setting that is one number. O(1).
bool is_in_range(Setting setting, double value);

}  // namespace evenlift
