// The thesis's "our algorithm": the mean over the methods that choose among candidates.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// A function that returns a value of an aggregate, or nothing if the aggregate lacks it.
using Pick = std::optional<double> (*)(const Aggregate&);
std::optional<double> pick_spread(const Aggregate& a);
std::optional<double> pick_share(const Aggregate& a);
std::optional<double> pick_coverage(const Aggregate& a);
std::optional<double> pick_closure(const Aggregate& a);

// The mean of a value over the methods that choose among candidates; nothing unless all of them
// have it. O(rows).
std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t robots, Pick pick);

// The method's spread of loads divided by the algorithm_average() of the spreads. Nothing if either
// is missing, or if the divisor is at most τ times the mean load for objects that weigh
// experiment_weight (measure.h). O(rows).
std::optional<double> spread_times(const std::vector<Aggregate>& aggregates, Method method,
                                   std::uint32_t robots);

struct Range {
  double least = 0, most = 0;
};

// The least and the greatest spread_times() for 2, 4, .. most_robots robots; nothing if there are
// no values. O(rows times most_robots).
std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Method method,
                                  std::uint32_t most_robots);

// The algorithm_average() of coverage minus the method's coverage, averaged over 4, 6, ..
// most_robots robots. Numbers of robots that lack either value are left out; the result is empty if
// none remains. Two robots do not count, since their coverage is 0. O(rows times most_robots).
std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Method method,
                                    std::uint32_t most_robots);

}  // namespace evenlift::experiment
