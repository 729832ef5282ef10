// The common parts of the tables of steps.
#pragma once

#include <cstddef>
#include <cstdint>

#include "evenlift/centre_of_mass.h"
#include "evenlift/trace.h"

namespace evenlift {

// Whether a table has one row for each kind of step, in order.
template <class Row, std::size_t size>
constexpr bool has_each_step(const Row (&rows)[size]) {
  for (std::size_t i = 0; i < size; ++i)
    if (rows[i].kind != static_cast<StepKind>(i)) return false;
  return size == step_kind_count;
}

// One step of a trace, as the functions in the tables' rows see it.
class LookedAtStep {
 protected:
  LookedAtStep(const Trace& trace, const StepDetail& detail)
      : trace_(trace), placement_(trace.placement), detail_(detail), item_(detail.step.item) {}

  // The object with its first `items` pieces of cargo.
  Loaded with_cargo(std::size_t items) const {
    return evenlift::with_cargo(placement_.own_centre, placement_.settings, items);
  }

  const Trace& trace_;
  const Placement& placement_;
  const StepDetail& detail_;
  std::uint32_t item_;
};

}  // namespace evenlift
