#include "evenlift/experiment/algorithm_average.h"

#include <algorithm>
#include <iterator>

#include "evenlift/tolerance.h"

namespace evenlift::experiment {
namespace {

// Whether a spread is zero except for rounding: it is at most τ times the mean load.
bool is_even(double spread, std::uint32_t robots) {
  return spread <= tau * experiment_weight / robots;
}

}  // namespace

std::optional<double> pick_spread(const Aggregate& a) { return a.spread.mean; }
std::optional<double> pick_share(const Aggregate& a) { return a.max_share.mean; }
std::optional<double> pick_coverage(const Aggregate& a) { return a.coverage.mean; }
std::optional<double> pick_closure(const Aggregate& a) { return a.form_closure; }

std::optional<double> algorithm_average(const std::vector<Aggregate>& aggregates,
                                        std::uint32_t robots, Pick pick) {
  double sum = 0;
  for (const Method method : candidate_methods) {
    const Aggregate* a = find(aggregates, method, robots);
    const std::optional<double> value = a ? pick(*a) : std::nullopt;
    if (!value) return std::nullopt;
    sum += *value;
  }
  return sum / static_cast<double>(std::size(candidate_methods));
}

std::optional<double> spread_times(const std::vector<Aggregate>& aggregates, Method method,
                                   std::uint32_t robots) {
  const std::optional<double> ours = algorithm_average(aggregates, robots, pick_spread);
  const Aggregate* other = find(aggregates, method, robots);
  if (!ours || !other || is_even(*ours, robots)) return std::nullopt;
  return other->spread.mean / *ours;
}

std::optional<Range> spread_ratio(const std::vector<Aggregate>& aggregates, Method method,
                                  std::uint32_t most_robots) {
  std::optional<Range> range;
  for (std::uint32_t robots = 2; robots <= most_robots; robots += 2) {
    const std::optional<double> times = spread_times(aggregates, method, robots);
    if (!times) continue;
    if (!range) range = {*times, *times};
    range->least = std::min(range->least, *times);
    range->most = std::max(range->most, *times);
  }
  return range;
}

std::optional<double> coverage_lead(const std::vector<Aggregate>& aggregates, Method method,
                                    std::uint32_t most_robots) {
  double sum = 0;
  int count = 0;
  for (std::uint32_t robots = 4; robots <= most_robots; robots += 2) {
    const std::optional<double> ours = algorithm_average(aggregates, robots, pick_coverage);
    const Aggregate* other = find(aggregates, method, robots);
    if (!ours || !other) continue;
    sum += *ours - other->coverage.mean;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

}  // namespace evenlift::experiment
