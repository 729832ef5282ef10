// The algorithm as one, where the thesis speaks of "our algorithm": the mean of its three metrics.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// A value of an aggregate; none where it has none.
using Pick = std::optional<double> (*)(const Aggregate&);
std::optional<double> pick_spread(const Aggregate& a);
std::optional<double> pick_share(const Aggregate& a);
std::optional<double> pick_coverage(const Aggregate& a);
std::optional<double> pick_closure(const Aggregate& a);

// The mean of area, circle and distance with that many teams, if all three have a value. O(rows).
std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t teams, Pick pick);

// How many times as large as the algorithm's spread with that many teams the method's is; none
// where one of them has none, and where the algorithm's loads are even to within τ of their mean.
// For objects of experiment_weight. O(rows).
std::optional<double> spread_times(const std::vector<Aggregate>& aggregates, Method method,
                                   std::uint32_t teams);

struct Range {
  double least = 0, most = 0;
};

// The least and the greatest spread_times for 1 .. most_teams teams; none if there is none.
// O(rows most_teams).
std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Method method,
                                  std::uint32_t most_teams);

// The mean over 2 .. most_teams teams of the algorithm's coverage less the method's (one team
// covers nothing). O(rows most_teams).
std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Method method,
                                    std::uint32_t most_teams);

}  // namespace evenlift::experiment
