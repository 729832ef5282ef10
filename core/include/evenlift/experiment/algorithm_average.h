// What the thesis calls "our algorithm": the mean of the three metrics.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// Picks a value of an aggregate; nothing if the aggregate does not have it.
using Pick = std::optional<double> (*)(const Aggregate&);
std::optional<double> pick_spread(const Aggregate& a);
std::optional<double> pick_share(const Aggregate& a);
std::optional<double> pick_coverage(const Aggregate& a);
std::optional<double> pick_closure(const Aggregate& a);

// The mean of area, circle and distance with that many teams, if all three have a value. O(rows).
std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t teams, Pick pick);

// The ratio of the method's spread to the algorithm's with that many teams, for objects of
// experiment_weight. Nothing if either is missing, or if the algorithm's loads are even to within τ
// of their mean. O(rows).
std::optional<double> spread_times(const std::vector<Aggregate>& aggregates, Method method,
                                   std::uint32_t teams);

struct Range {
  double least = 0, most = 0;
};

// The least and the greatest spread_times for 1 .. most_teams teams; nothing if there is none.
// O(rows most_teams).
std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Method method,
                                  std::uint32_t most_teams);

// The mean over 2 .. most_teams teams of the algorithm's coverage less the method's (one team
// covers nothing). O(rows most_teams).
std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Method method,
                                    std::uint32_t most_teams);

}  // namespace evenlift::experiment
