// Reads the values of settings from text, writes them as text, and checks their ranges. The type of
// a value determines its syntax, so few rows of the table in settings.cpp need their own functions.
#pragma once

#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

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
bool take(std::string_view text, const SettingRange&, std::optional<Vec2>& centre);
bool take(std::string_view text, const SettingRange&, Overlays& overlays);
bool take(std::string_view text, const SettingRange&, RobotSize& robot);
bool take(std::string_view text, const SettingRange&, NoGo& no_go);
bool take(std::string_view text, const SettingRange&, Points& supports);
bool take(std::string_view text, const SettingRange&, Capacities& capacities);
bool take(std::string_view text, const SettingRange&, CargoList& cargo);
std::string text_of(const std::optional<Vec2>& centre, const SettingRange&);
std::string text_of(const Overlays& overlays, const SettingRange&);
std::string text_of(const RobotSize& robot, const SettingRange&);
std::string text_of(const NoGo& no_go, const SettingRange&);
std::string text_of(const Points& supports, const SettingRange&);
std::string text_of(const Capacities& capacities, const SettingRange&);
std::string text_of(const CargoList& cargo, const SettingRange&);
bool is_within(const std::optional<Vec2>& centre, const SettingRange&);
bool is_within(const Overlays& overlays, const SettingRange&);
bool is_within(const RobotSize& robot, const SettingRange&);
bool is_within(const NoGo& no_go, const SettingRange&);
bool is_within(const Points& supports, const SettingRange&);
bool is_within(const Capacities& capacities, const SettingRange&);
bool is_within(const CargoList& cargo, const SettingRange&);

// --- The kind of a value in words, such as "a number from 0 to 1"

inline std::string bound_text(double bound) {
  return bound <= 1e15 ? std::to_string(static_cast<std::uint64_t>(bound)) : "1e100";
}

template <class Value>
std::string kind_in_words(const SettingRange& range) {
  if constexpr (std::is_same_v<Value, double>) {
    return say(range.least > 0 ? "a number greater than 0, from {least} to {most}"
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
