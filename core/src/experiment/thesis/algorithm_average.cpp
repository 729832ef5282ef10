#include "evenlift/experiment/algorithm_average.h"

#include <algorithm>

#include "evenlift/tolerance.h"

namespace evenlift::experiment {
namespace {

// Whether a spread is zero except for rounding: the loads of 100 kg differ by less than τ of their
// mean.
bool is_even(double spread, std::uint32_t teams) {
  return spread <= tau * experiment_weight / (2.0 * teams);
}

}  // namespace

std::optional<double> pick_spread(const Aggregate& a) { return a.spread.mean; }
std::optional<double> pick_share(const Aggregate& a) { return a.max_share.mean; }
std::optional<double> pick_coverage(const Aggregate& a) { return a.coverage.mean; }
std::optional<double> pick_closure(const Aggregate& a) { return a.form_closure; }

std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t teams, Pick pick) {
  double sum = 0;
  for (const Method method : {Method::area, Method::circle, Method::distance}) {
    const Aggregate* a = find(aggregates, method, teams);
    const std::optional<double> value = a ? pick(*a) : std::nullopt;
    if (!value) return std::nullopt;
    sum += *value;
  }
  return sum / 3;
}

std::optional<double> spread_times(const std::vector<Aggregate>& aggregates, Method method,
                                   std::uint32_t teams) {
  const std::optional<double> ours = algorithm_average(aggregates, teams, pick_spread);
  const Aggregate* other = find(aggregates, method, teams);
  if (!ours || !other || is_even(*ours, teams)) return std::nullopt;
  return other->spread.mean / *ours;
}

std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Method method,
                                  std::uint32_t most_teams) {
  std::optional<Range> range;
  for (std::uint32_t teams = 1; teams <= most_teams; ++teams) {
    const std::optional<double> times = spread_times(aggregates, method, teams);
    if (!times) continue;
    if (!range) range = {*times, *times};
    range->least = std::min(range->least, *times);
    range->most = std::max(range->most, *times);
  }
  return range;
}

std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Method method,
                                    std::uint32_t most_teams) {
  double sum = 0;
  int count = 0;
  for (std::uint32_t teams = 2; teams <= most_teams; ++teams) {
    const std::optional<double> ours = algorithm_average(aggregates, teams, pick_coverage);
    const Aggregate* other = find(aggregates, method, teams);
    if (!ours || !other) continue;
    sum += *ours - other->coverage.mean;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

}  // namespace evenlift::experiment
