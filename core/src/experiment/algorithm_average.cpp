#include "evenlift/experiment/algorithm_average.h"

#include <algorithm>

namespace evenlift {

std::optional<double> pick_spread(const Aggregate& a) { return a.spread.mean; }
std::optional<double> pick_share(const Aggregate& a) { return a.max_share.mean; }
std::optional<double> pick_coverage(const Aggregate& a) { return a.coverage.mean; }
std::optional<double> pick_closure(const Aggregate& a) { return a.form_closure; }

std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t teams, Pick pick) {
  double sum = 0;
  for (const Metric method : {Metric::area, Metric::circle, Metric::distance}) {
    const Aggregate* a = find(aggregates, method, teams);
    const std::optional<double> value = a ? pick(*a) : std::nullopt;
    if (!value) return std::nullopt;
    sum += *value;
  }
  return sum / 3;
}

std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Metric method,
                                  std::uint32_t most_teams) {
  std::optional<Range> range;
  for (std::uint32_t teams = 1; teams <= most_teams; ++teams) {
    const std::optional<double> ours = algorithm_average(aggregates, teams, pick_spread);
    const Aggregate* other = find(aggregates, method, teams);
    if (!ours || !other || *ours <= 0) continue;
    const double ratio = other->spread.mean / *ours;
    if (!range) range = {ratio, ratio};
    range->least = std::min(range->least, ratio);
    range->most = std::max(range->most, ratio);
  }
  return range;
}

std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Metric method,
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

}  // namespace evenlift
