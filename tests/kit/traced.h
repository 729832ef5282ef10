// Traces that must succeed, and the numbers of their steps.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "evenlift/trace.h"
#include "kit/catch.h"

namespace evenlift::testing {

inline Trace traced(const Placement& placement, const Units& units = {}) {
  Result<Trace> trace = make_trace(placement, HistoryLength::whole, units);
  INFO((trace ? "" : trace.error().message));
  REQUIRE(trace.ok());
  return *std::move(trace);
}

inline std::optional<double> number_if_any(const Trace& trace, const StepDetail& detail,
                                           std::string_view name) {
  for (const Number& number : numbers(trace, detail))
    if (number.name == name) return number.value;
  return std::nullopt;
}

// A step without it fails the test.
inline double number_of(const Trace& trace, const StepDetail& detail, std::string_view name) {
  const std::optional<double> number = number_if_any(trace, detail, name);
  INFO(name);
  REQUIRE(number);
  return *number;
}

}  // namespace evenlift::testing
