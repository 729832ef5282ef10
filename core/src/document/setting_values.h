// Reads the values of settings from text, writes them as text, and checks their ranges. The type of
// a value determines its syntax, so few rows of the table in settings.cpp need their own functions.
#pragma once

#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/numbers.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"

namespace evenlift::setting_value {

// --- Numbers

inline bool is_within(double value, const SettingRange& range) {
  return value >= range.least && value <= range.most;  // false for NaN
}
inline bool is_within(std::uint32_t value, const SettingRange& range) {
  return is_within(static_cast<double>(value), range);
}
inline bool is_within(std::uint64_t, const SettingRange&) { return true; }

inline std::optional<double> parsed(std::string_view text, const SettingRange&, double) {
  return read_number(text);
}
inline std::optional<std::uint64_t> parsed(std::string_view text, const SettingRange&,
                                           std::uint64_t) {
  return read_whole(text);
}
inline std::optional<std::uint32_t> parsed(std::string_view text, const SettingRange&,
                                           std::uint32_t) {
  const std::optional<std::uint64_t> value = read_whole(text);
  if (!value || *value > ~std::uint32_t{0}) return std::nullopt;
  return static_cast<std::uint32_t>(*value);
}

inline std::string text_of(double value, const SettingRange&) { return shortest(value); }
inline std::string text_of(std::uint32_t value, const SettingRange&) {
  return std::to_string(value);
}
inline std::string text_of(std::uint64_t value, const SettingRange&) {
  return std::to_string(value);
}

// --- Enumerations, by the names of their values

inline const auto& all_of(Method) { return named_methods; }
inline const auto& all_of(Goal) { return all_goals; }
inline const auto& all_of(Positions) { return all_positions; }
inline const auto& all_of(LengthUnit) { return all_length_units; }
inline const auto& all_of(WeightUnit) { return all_weight_units; }

template <class Name>
concept Named = std::is_enum_v<Name>;

template <Named Name>
bool is_within(Name value, const SettingRange&) {
  for (const Name each : all_of(value))
    if (each == value) return true;
  return false;
}

template <Named Name>
std::optional<Name> parsed(std::string_view text, const SettingRange&, Name) {
  for (const Name each : all_of(Name{}))
    if (text == name(each)) return each;
  return std::nullopt;
}

template <Named Name>
std::string text_of(Name value, const SettingRange&) {
  return std::string(name(value));
}

template <Named Name>
std::string_view name_at(std::size_t i) {
  const auto& all = all_of(Name{});
  return i < std::size(all) ? name(all[i]) : std::string_view();
}

// --- Optional values of the types above

template <class Value>
bool is_within(const std::optional<Value>& value, const SettingRange& range) {
  return !value || is_within(*value, range);
}

template <class Value>
std::string text_of(const std::optional<Value>& value, const SettingRange& range) {
  return value ? text_of(*value, range) : std::string(range.unset);
}

// Returns whether the text is valid and its value in range. If so, stores the value.
template <class Value>
bool take(std::string_view text, const SettingRange& range, Value& value) {
  const std::optional<Value> read = parsed(text, range, Value{});
  if (!read || !is_within(*read, range)) return false;
  value = *read;
  return true;
}

template <class Value>
bool take(std::string_view text, const SettingRange& range, std::optional<Value>& value) {
  if (!range.unset.empty() && text == range.unset) {
    value.reset();
    return true;
  }
  Value given{};
  if (!take(text, range, given)) return false;
  value = given;
  return true;
}

// --- Values with their own syntax (setting_values.cpp)

using NoGo = std::vector<EdgePart>;
using Capacities = std::vector<std::optional<double>>;
using CargoList = std::vector<Cargo>;
using Readings = std::vector<double>;
bool take(std::string_view text, const SettingRange&, Readings& readings);
bool take(std::string_view text, const SettingRange&, ReadingError& error);
std::string text_of(const Readings& readings, const SettingRange&);
std::string text_of(const ReadingError& error, const SettingRange&);
bool is_within(const Readings& readings, const SettingRange&);
bool is_within(const ReadingError& error, const SettingRange&);
bool take(std::string_view text, const SettingRange&, std::optional<Vec2>& centre);
bool take(std::string_view text, const SettingRange&, Overlays& overlays);
bool take(std::string_view text, const SettingRange&, RobotSize& robot);
bool take(std::string_view text, const SettingRange&, NoGo& no_go);
bool take(std::string_view text, const SettingRange&, Points& supports);
bool take(std::string_view text, const SettingRange&, Capacities& capacities);
bool take(std::string_view text, const SettingRange&, CargoList& cargo);
bool take(std::string_view text, const SettingRange&, std::vector<std::string>& names);
std::string text_of(const std::optional<Vec2>& centre, const SettingRange&);
std::string text_of(const Overlays& overlays, const SettingRange&);
std::string text_of(const RobotSize& robot, const SettingRange&);
std::string text_of(const NoGo& no_go, const SettingRange&);
std::string text_of(const Points& supports, const SettingRange&);
std::string text_of(const Capacities& capacities, const SettingRange&);
std::string text_of(const CargoList& cargo, const SettingRange&);
std::string text_of(const std::vector<std::string>& names, const SettingRange&);
bool is_within(const std::optional<Vec2>& centre, const SettingRange&);
bool is_within(const Overlays& overlays, const SettingRange&);
bool is_within(const RobotSize& robot, const SettingRange&);
bool is_within(const NoGo& no_go, const SettingRange&);
bool is_within(const Points& supports, const SettingRange&);
bool is_within(const Capacities& capacities, const SettingRange&);
bool is_within(const CargoList& cargo, const SettingRange&);
bool is_within(const std::vector<std::string>& names, const SettingRange&);

// --- The kind of a value in words, such as "a number from 0 to 1"

inline std::string bound_text(double bound) {
  return bound <= 1e15 ? std::to_string(static_cast<std::uint64_t>(bound)) : "1e100";
}

template <class Value>
std::string kind_in_words(const SettingRange& range) {
  if constexpr (std::is_same_v<Value, double>) {
    return say(range.least > 0 && range.least < 1
                   ? "a number greater than 0, from {least} to {most}"
                   : "a number from {least} to {most}",
               {shortest(range.least), bound_text(range.most)});
  } else if constexpr (std::is_same_v<Value, std::uint64_t>) {
    return say("a whole number from {least} to {most}", {"0", std::to_string(~std::uint64_t{0})});
  } else if constexpr (std::is_same_v<Value, std::uint32_t>) {
    return say("a whole number from {least} to {most}",
               {bound_text(range.least), bound_text(range.most)});
  } else {
    const auto& all = all_of(Value{});
    const std::size_t first = name(all[0]) == "none" ? 1 : 0;  // "none" comes last
    std::string names[2];                                      // all but the last, and the last
    for (std::size_t i = 0; i < std::size(all); ++i) {
      if (i > 0) names[0] += (i > 1 ? ", " : "") + names[1];
      names[1] = name(all[(i + first) % std::size(all)]);
    }
    return say_written("{names} or {last}", names, 2);
  }
}

}  // namespace evenlift::setting_value

namespace evenlift {

// --- Reads the slope of the ground and the acceleration as users type them.

// Reads a ratio such as 0.08, a percentage such as 8%, or an angle such as 4.6deg or 4.6°; and an
// acceleration in g, or with its unit, such as 2 m/s2. Spaces may precede the unit. Returns whether the
// text is valid and its value in range. If so, stores the value as a ratio, or in g.
bool read_slope(std::string_view text, const SettingRange& range, double& slope);
// Reads a part such as 0.05 or 5%.
bool read_part_of_all(std::string_view text, const SettingRange& range, double& part);
// Reads a direction: two numbers such as 1,0 that are not both 0, an angle from the x axis
// counter-clockwise such as 90deg, or "none".
bool read_direction(std::string_view text, std::optional<Vec2>& direction);
bool read_acceleration(std::string_view text, const SettingRange& range, double& acceleration);

// --- Reads the places and capacities of supports from text, and writes the capacities. supports_text()
// (settings.h) writes the places.

// Reads "none" or a list (list_text.h) of supports x,y or x,y@capacity, such as "0,0 160,0@30".
// Returns whether the text is valid. If so, sets the document's supports, their capacities and, if
// there are supports, its method; otherwise changes nothing. O(bytes).
bool read_supports(std::string_view text, Document& document);

// The first item that is not a valid support, as refused_item() (list_text.h) returns it. O(bytes).
std::string_view refused_support(std::string_view text);

// read_capacities() reads a list such as "30,none,40", or an empty text for no capacities. It
// returns whether the text is valid, and changes the capacities only if it is. capacities_text()
// writes such a text. O(bytes).
using Capacities = std::vector<std::optional<double>>;
bool read_capacities(std::string_view text, Capacities& capacities);
std::string capacities_text(const Capacities& capacities);

// Whether `capacities` is empty, or has at most most_supports entries of which at least one is set
// and all that are set are in range. O(capacities).
bool are_capacities(const Capacities& capacities);

// --- Reads the sizes of robots and the no-go edges and parts from text, and checks them.

// Commas separate the words of the text. Calls read(word) for each word in order until a call
// returns false. Returns whether all words were accepted.
template <class Read>
bool for_each_word(std::string_view text, Read read) {
  while (true) {
    const std::size_t comma = text.find(',');
    if (!read(text.substr(0, comma))) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}

// Each function returns whether the text is valid, and changes the setting only if it is. O(bytes).
bool read_size(std::string_view text, double& size);
bool read_robot(std::string_view text, RobotSize& robot);
bool read_no_go(std::string_view text, std::vector<EdgePart>& no_go);

// The first word that is not an edge or part of an edge; empty if there is no such word, or if it
// is not quotable. O(bytes).
std::string_view refused_part(std::string_view text);

// Whether a part of a text can be quoted in a message: at most 40 printable ASCII characters.
// O(bytes).
bool is_quotable(std::string_view part);

// Whether all sizes are in range. O(1).
bool is_robot_size(const RobotSize& robot);
// Whether all parts and their number are in range. O(parts).
bool is_no_go(const std::vector<EdgePart>& no_go);

// --- Names of supports and cargo.

// Reads "none" or a list (list_text.h) of names, such as north "south west" "", where "" is no name.
// Returns whether the text is valid, and changes the names only if it is. O(bytes).
bool read_names(std::string_view text, std::vector<std::string>& names);

// A name as it stands in a list: between quotation marks if it has spaces or quotation marks, or is
// empty or "none". O(bytes).
std::string name_text(std::string_view name);

// The reason why a name is refused; nullptr if it is valid. A name must be UTF-8 without control
// characters and have at most max_name_characters. O(bytes).
const char* fault_of_name(std::string_view name);

// Whether there are at most most_supports names, each valid. O(bytes).
bool are_names(const std::vector<std::string>& names);

// --- Reads cargo from text and checks it. cargo_text() (settings.h) writes it.

// Reads "none" or a list (list_text.h) of items x,y:weight or x,y:weight:name, such as
// "8,8:24 0,0:3:\"a box\"". A quotation mark within a quoted name is doubled. Returns whether the
// text is valid, and changes the cargo only if it is. O(bytes).
bool read_cargo(std::string_view text, std::vector<Cargo>& cargo);

// The first item that is not valid cargo, as refused_item() (list_text.h) returns it. O(bytes).
std::string_view refused_cargo(std::string_view text);

// The reason why a weight of cargo is refused; nullptr if it is valid. O(1).
const char* fault_of_cargo_weight(double weight);

// Whether there are at most max_cargo items, each with coordinates of at most max_coordinate in
// size, a valid weight and a valid name. O(bytes of names).
bool is_cargo(const std::vector<Cargo>& cargo);

}  // namespace evenlift
