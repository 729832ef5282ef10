// How firmly robots hold the object of a trace.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/closure.h"
#include "evenlift/trace.h"

namespace evenlift {

// The margin (closure.h) of robots that lift at these points, where they touch the object, by the
// contacts that count: those that are far enough from corners. None without such contacts.
inline std::optional<double> margin_of(const Trace& trace,
                                       const std::vector<LiftingPoint>& robots) {
  const Placement& placement = trace.placement;
  const auto touching = contacts(trace.polygon, contact_points(placement.stands.get(), robots));
  const double clear = firm_hold(placement).clear;
  return analyse_hold(trace.polygon, trace.centre, clear_contacts(trace.polygon, touching, clear))
      .margin;
}

}  // namespace evenlift
