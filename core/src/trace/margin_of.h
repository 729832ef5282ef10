// How firmly robots hold the object of a trace.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/closure.h"
#include "evenlift/trace.h"

namespace evenlift {

// The margin (closure.h) of robots that lift at these points, where they touch the object; none
// without contacts.
inline std::optional<double> margin_of(const Trace& trace,
                                       const std::vector<LiftingPoint>& robots) {
  const auto touching = contact_points(trace.placement.stands.get(), robots);
  return analyse_hold(trace.polygon, trace.centre, touching).margin;
}

}  // namespace evenlift
