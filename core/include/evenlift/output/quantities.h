// One row for each number or yes-or-no that is told of a placement: its names, its unit, how it is
// read from a report, what it means, which way is better, and where it appears. From these rows come
// members of JSON, the facts of program and page, the conditions of `--require`, the columns of
// `--shape all`, and the page's comparison of two methods. A new quantity is a new row.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/output/words.h"

namespace evenlift {

enum class Unit : std::uint8_t { yes_or_no, count, number, share, weight, length, degrees };
enum class Better : std::uint8_t { neither, more, less };

struct Quantity {
  // A value: 1 for yes and 0 for no; a share from 0 to 1; infinite if there is no limit. Nothing if
  // there is no value, as for a load of an object that falls.
  std::optional<double> (*value)(const Reported& of) = nullptr;
  Unit unit = Unit::number;
  Better better = Better::neither;
  Toward rounded = Toward::nearest;  // limits down and loads up, where a rounded value must be safe

  // Where it appears, unless these are empty. A condition, a member and a column need `value`; in
  // JSON, no value and no limit are both null.
  std::string_view condition;      // its name in --require, with `subject`
  std::string_view subject;        // there: a sentence if it is yes or no, else its subject
  std::string_view json;           // "coverage", or "loads.max": of loads, closure, robustness, ...
  const char* label = nullptr;     // in the list of facts, with `about`
  std::string_view column;         // the heading of a column
  const char* compared = nullptr;  // in a comparison, perhaps with {unit} for that of weights

  // Of facts: the meaning, and the condition under which it is true; and the value as text, if it is
  // not just the rounded value with its unit. The text is empty if the fact has no place among the
  // others now.
  const char* about = nullptr;
  std::string (*in_words)(const Reported& of) = nullptr;

  bool needs_failures = false;    // of Asked
  bool needs_capacities = false;  // otherwise it has no column
};

// All quantities, in the order in which they appear.
std::span<const Quantity> quantities();

// A label, a value and a sentence that explains them.
struct Fact {
  const char* label;
  std::string value;
  const char* about;
};
std::vector<Fact> facts_in_words(const Reported& of);

// A quantity of two placements of one object: their values, and which of them is better, if one is.
struct Compared {
  std::string label;
  std::array<std::string, 2> values;
  std::optional<std::size_t> better;
};
std::vector<Compared> compared_in_words(const Reported& a, const Reported& b);

// Writes a value of a column: "15.2", "81 %", "yes". `largest` is the largest value of the column.
std::string cell_in_words(const Quantity& quantity, double value, double largest);

// Adds the unit of the quantity to a number that is already text.
std::string with_unit(const std::string& number, Unit unit, const Units& units);

}  // namespace evenlift
