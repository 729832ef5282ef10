// The margin of robots in a trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/centre_of_mass.h"
#include "evenlift/closure.h"
#include "evenlift/trace.h"

namespace evenlift {

// The margin (closure.h) of robots that lift at these points. Only contacts far enough from corners
// count; nullopt if there are no such contacts.
inline std::optional<double> margin_of(const Trace& trace,
                                       const std::vector<LiftingPoint>& robots) {
  const Placement& placement = trace.placement;
  const auto touching = contacts(trace.polygon(), contact_points(placement.stands.get(), robots));
  const double clear = hold_requirements(placement).clear;
  return analyse_hold(trace.polygon(), trace.centre,
                      clear_contacts(trace.polygon(), touching, clear))
      .margin;
}

// --- The common parts of the tables of steps.

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

// --- Balanced robots in a trace.

// Repeats the search for balanced robots and records it in the trace. The result becomes the
// trace's placement. If the search is too long to show, the function returns an error for
// HistoryLength::whole, and records nothing for HistoryLength::start.
std::optional<InputError> trace_search(Trace& trace, HistoryLength length);

void look_at_balanced(const Trace& trace, StepDetail& detail);

// The set of balanced robots that the step shows: its own or, if it has none, the final set of the
// search. Null for the steps about the object, and if there is no such set.
const BalancedSet* balanced_set_at(const Trace& trace, const Step& step);

}  // namespace evenlift
