// Settings by name and from text: the one table of their names, ranges and sentences, for options,
// window.evenlift.set(), lessons, links, and what the page keeps.
#pragma once

#include <optional>
#include <string_view>

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
  capacity
};

// The setting's name in JSON and scripts ("min_ratio"), and back; nothing for an unknown name. With
// hyphens it is the program's option and the lesson's key. O(1).
std::string_view name(Setting setting);
std::optional<Setting> setting_from_name(std::string_view text);

// What the setting's value has to be: a sentence without a full stop, such as "the minimum load
// ratio is a number from 0 to 1". O(1).
const char* requirement(Setting setting);

// The refusal of a value: code bad_setting, the requirement, and a place that names the setting.
InputError setting_error(Setting setting);

// Puts a setting of the document, given as text, in its place:
//   teams      a whole number from 1 to max_teams, or "max" for every candidate
//   metric     a name such as "area"
//   min_ratio  a number from 0 to 1
//   com        two numbers "x,y", or "centroid"
//   weight     a number above 0
//   seed       a whole number
//   overlays   names with commas between them, such as "chords,hull", or "none"
//   step       a whole number of at most 32 bits, or "none"
// Numbers have the syntax of read_number() and whole numbers that of read_whole(): no spaces, no
// hexadecimal. Only around the comma of com there may be spaces and tabs. A text that is anything
// else, or out of range, is refused and changes nothing; capacity is not the document's and always
// refused. O(bytes).
std::optional<InputError> read_setting(Setting setting, std::string_view text, Document& document);

// What one robot can carry, in the unit of the weight: a number above 0. O(bytes).
std::optional<double> read_capacity(std::string_view text);

// Whether each setting by itself is in its range. The error's place names the setting. Which
// settings go together is check_settings()'s to say (placement.h). O(1).
std::optional<InputError> check_ranges(const Settings& settings);

// The rules themselves, ends included where they say so. O(1).
bool is_min_ratio(double value);  // 0 <= value <= 1
bool is_weight(double value);     // 0 < value, finite; of a capacity, too

}  // namespace evenlift
