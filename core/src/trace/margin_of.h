// The margin of robots in a trace.
#pragma once

#include <optional>
#include <vector>

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

}  // namespace evenlift
