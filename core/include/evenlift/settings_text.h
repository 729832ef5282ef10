// Settings by name and from text. This is the only table of their names, ranges and messages, for
// the program's options, window.evenlift.set(), lessons, links, and what the page stores.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

enum class Setting : std::uint8_t {
  teams,
  method,
  min_ratio,
  com,
  weight,
  seed,
  overlays,
  step,
  capacity,
  com_radius,
  loads,
  failed,
  robots,
  goal,
  min_margin,
  apart,
  survive,
  unit,
  weight_unit,
  positions,
  robot,
  no_go,
  robot_radius,
  robot_reach,
  robot_depth,
  robot_width,
  robot_gap,
  clear,
  end_of_settings  // no setting: it stays the last and counts them, so that each needs its row
};

// The setting's name in JSON and scripts, such as "min_ratio"; and the setting of a name, or
// nothing for an unknown name. With hyphens it is the program's option and the lesson's key. O(1).
std::string_view name(Setting setting);
std::optional<Setting> setting_from_name(std::string_view text);

// A sentence that says what the setting's value must be, without a full stop, such as "the minimum
// load ratio is a number from 0 to 1". O(1).
const char* requirement(Setting setting);

// The error for a bad value: code bad_setting, the requirement or another reason, and a place that
// names the setting.
InputError setting_error(Setting setting);
InputError setting_error(Setting setting, std::string why);

// Sets a setting of the document from text:
//   teams      a whole number from 1 to max_teams, or "max" for every candidate
//   metric     a name such as "area"
//   min_ratio  a number from 0 to 1
//   com        two numbers "x,y", or "centroid"
//   weight     a number from 1e-100 to 1e100
//   seed       a whole number
//   overlays   names with commas between them, such as "chords,hull", or "none"
//   step       a whole number of at most 32 bits, or "none"
//   robots     a whole number from 2 to 64
//   goal       "cover" or "hold"
//   min_margin a number from 0 to 1
//   apart      a number from 0 to 1e9
//   clear      a number from 0 to 1e9
//   survive    a whole number from 0 to 30
//   com_radius a number from 0 to 1e9
//   capacity   a number from 1e-100 to 1e100, or "none"
//   unit       "m", "cm", "mm" or "in", or "none"
//   weight_unit "kg", "t", "N" or "lb"
//   positions  "best" or "range"
//   robot      some of "r", "reach", "depth", "width" and "gap", each at most once and with a number
//              from 0 to 1e9, such as "r=30,reach=5"; what is not named is 0. Or "none"
//   robot_radius, robot_reach, robot_depth, robot_width, robot_gap   one of these numbers
//   no_go      edges from 1, or parts of them from 0 to 1, such as "3,5:0.25-0.75"; or "none"
// Numbers have the syntax of read_number(), whole numbers that of read_whole(): no spaces and no
// hexadecimal. Only the comma of com may have spaces and tabs around it. Any other text, and any value
// out of range, is an error and changes nothing; of no_go the error quotes the first part that is wrong if it is short. loads and failed are not settings of a document, and
// always an error. A setting that says where robots stand puts robots that were moved by hand back:
// every one except weight, overlays, step, com_radius, capacity, unit and weight_unit. O(bytes).
std::optional<InputError> read_setting(Setting setting, std::string_view text, Document& document);

// The texts of two settings as read_setting() takes them. O(bytes).
std::string robot_text(const RobotSize& robot);
std::string no_go_text(const std::vector<EdgePart>& no_go);

// Robots that were moved by hand, as text: each balanced robot as EDGE:PART, each team as
// TEAM@EDGE:PART/EDGE, with numbers from 1 and parts from 0 to 1, and commas between them, such as
// "3:0.25,5:0.5,9:1" or "2@3:0.25/9"; an empty text if there are none. read_moved() gives nothing for
// any other text. O(bytes).
std::string moved_text(const Moved& moved);
std::optional<Moved> read_moved(std::string_view text);

// Whether the numbers of moved robots are within their bounds, and teams in ascending order. O(robots).
bool is_moved(const Moved& moved);

// The number of the robot that fails, from 1, from text: a whole number, or "none", which is 0. O(bytes).
std::optional<std::uint64_t> read_failed(std::string_view text);

// Checks that each setting by itself is in its range. The error's place names the setting. Whether
// settings go together is checked by check_settings() (placement.h). O(parts of no_go).
std::optional<InputError> check_ranges(const Settings& settings);

// The rules themselves. O(1).
bool is_min_ratio(double value);  // 0 <= value <= 1
bool is_weight(double value);     // min_weight .. max_weight; also the rule of a capacity
bool is_length(double value);  // 0 .. max_length; the rule of apart, clear, com_radius, robot sizes

}  // namespace evenlift
