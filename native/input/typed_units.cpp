#include "input/typed_units.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string_view>

#include "evenlift/numbers.h"
#include "input/command_line.h"
#include "input/options.h"

namespace evenlift::native {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

struct Kinds {
  bool lengths = false, weights = false;
  // In an item, the colon after which its name begins, counted from 1; 0 for settings without names.
  int colon_of_name = 0;
};

Kinds kinds_of(Setting setting) {
  const SettingRow& row = row_of(setting);
  if (setting == Setting::cargo) return {true, true, 2};
  if (setting == Setting::supports) return {true, true, 1};
  if (setting == Setting::com || setting == Setting::robot) return {true, false};
  if (setting == Setting::readings || setting == Setting::readings_tilted ||
      setting == Setting::reading_error || setting == Setting::support_capacities)
    return {false, true};
  return {row.is_length, row.is_weight};
}

// How many of its own unit the typed one is; nothing if the word is no unit of these kinds.
std::optional<double> factor_of(std::string_view word, const Kinds& kinds, Setting setting,
                                const Units& units) {
  for (const WeightUnit unit : all_weight_units)
    if (kinds.weights && word == name(unit))
      return in_kilograms(1, unit) / in_kilograms(1, units.weight);
  for (const LengthUnit unit : all_length_units) {
    if (!kinds.lengths || unit == LengthUnit::none || word != name(unit)) continue;
    if (units.length == LengthUnit::none)
      throw Failure{bad_input_status, as_typed(name(setting)),
                    "a length is in " + std::string(word) +
                        ", but the coordinates have no unit; --unit names theirs"};
    return in_metres(1, unit) / in_metres(1, units.length);
  }
  return std::nullopt;
}

std::string with_digits(double value, std::string_view typed) {
  const auto digits = std::count_if(typed.begin(), typed.end(), is_digit);
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", std::clamp(static_cast<int>(digits), 9, 12), value);
  return shortest(std::strtod(text, nullptr));
}

}  // namespace

std::string in_own_units(Setting setting, const std::string& text, const Units& units) {
  const Kinds kinds = kinds_of(setting);
  if (!kinds.lengths && !kinds.weights) return text;
  const std::string_view all = text;
  std::string own;
  int colons = 0;
  for (std::size_t i = 0; i < all.size();) {
    if (is_space(all[i])) colons = 0;
    if (all[i] == ':' && ++colons == kinds.colon_of_name) {  // a name, perhaps between quotes
      bool quoted = false;
      for (; i < all.size() && (quoted || !is_space(all[i])); ++i) {
        if (all[i] == '"') quoted = !quoted;
        own += all[i];
      }
      continue;
    }
    const bool begins = is_digit(all[i]) || all[i] == '.';
    if (!begins) {
      own += all[i++];
      continue;
    }
    std::size_t end = all.find_first_not_of("0123456789.", i);
    end = std::min(end, all.size());
    const std::size_t sign =
        end + 1 < all.size() && (all[end + 1] == '+' || all[end + 1] == '-') ? 2 : 1;
    const bool has_exponent = end + sign < all.size() && (all[end] == 'e' || all[end] == 'E') &&
                              is_digit(all[end + sign]);
    if (has_exponent) end = std::min(all.find_first_not_of("0123456789", end + sign), all.size());
    const std::size_t unit = std::min(all.find_first_not_of(' ', end), all.size());
    std::size_t after = unit;
    while (after < all.size() && is_letter(all[after])) ++after;
    const std::string_view number = all.substr(i, end - i), word = all.substr(unit, after - unit);
    const bool is_whole_word =
        after == all.size() ||
        std::string_view(" \t\r\n,:@").find(all[after]) != std::string_view::npos;
    const std::optional<double> value = read_number(number),
                                factor = is_whole_word ? factor_of(word, kinds, setting, units)
                                                       : std::nullopt;
    if (!value || !factor) {
      own += number;
      i = end;
      continue;
    }
    own += *factor == 1 ? std::string(number) : with_digits(*value * *factor, number);
    i = after;
  }
  return own;
}

}  // namespace evenlift::native
