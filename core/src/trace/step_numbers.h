// The numbers of the steps, under their JSON names.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/trace.h"
#include "trace/step_rows.h"

namespace evenlift {

// Each step's row in steps.cpp names the function for its numbers.
class StepNumbers : LookedAtStep {
 public:
  StepNumbers(const Trace& trace, const StepDetail& detail) : LookedAtStep(trace, detail) {}

  void polygon();
  void centroid();
  void centre();
  void radial();
  void ray();
  void slopes();
  void sections();
  void outcome();
  void opposite();
  void duplicates();
  void candidates();
  void directions();
  void scores();
  void team();
  void base();
  void fewer();
  void share();
  void loads();
  void coverage();
  void contacts();
  void cut();
  void slide();
  void closure();
  void second_order();
  void result();
  void lever();
  void three();
  void many();
  void rest();
  void mirror();
  void completion();
  void start();
  void exchange();
  void round();
  void settled();
  void failure();
  void failures();
  void pairs();
  void range();
  void swap();
  void held();
  void stands();
  void support();
  void equations();
  void each_load();
  void by_springs();
  void extremes();
  void falls();
  void cargo();

  std::vector<Number> take() && { return std::move(numbers_); }

 private:
  void add(std::string_view name, double value) { numbers_.push_back({name, value}); }
  void count(std::string_view name, std::size_t value) { add(name, static_cast<double>(value)); }
  void point(std::string_view x, std::string_view y, const Vec2& p);
  void ratio_and_candidate(double ratio, std::optional<std::uint32_t> candidate);

  void robots_and_coverage();

  std::vector<Number> numbers_;
};

}  // namespace evenlift
