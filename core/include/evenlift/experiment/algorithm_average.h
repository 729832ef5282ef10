// The algorithm as one, where the thesis speaks of "our algorithm": the mean of its three metrics.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift {

// A value of an aggregate; none where it has none.
using Pick = std::optional<double> (*)(const Aggregate&);
std::optional<double> pick_spread(const Aggregate& a);
std::optional<double> pick_share(const Aggregate& a);
std::optional<double> pick_coverage(const Aggregate& a);
std::optional<double> pick_closure(const Aggregate& a);

// The mean of area, circle and distance with that many teams, if all three have a value. O(rows).
std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t teams, Pick pick);

struct Range {
  double least = 0, most = 0;
};

// For 1 .. most_teams teams how many times the algorithm's spread the method's is; none where there
// is nothing to compare, or the algorithm's is 0. O(rows most_teams).
std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Metric method,
                                  std::uint32_t most_teams);

// The mean over 2 .. most_teams teams of the algorithm's coverage less the method's (one team
// covers nothing). O(rows most_teams).
std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Metric method,
                                    std::uint32_t most_teams);

}  // namespace evenlift
