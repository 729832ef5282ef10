#include "experiment/thesis/by_polygon.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

namespace evenlift::experiment {
namespace {

// The candidate of the last team by each metric; nothing if a metric has no such team.
std::optional<std::vector<std::uint32_t>> choices(const PolygonResult& result,
                                                  std::uint32_t teams) {
  std::vector<std::uint32_t> chosen;
  for (const Method method : candidate_methods) {
    const Measurement* m = find(result, method, 2 * teams);
    if (!m || !m->chosen) return std::nullopt;
    chosen.push_back(*m->chosen);
  }
  return chosen;
}

bool all_same(const std::vector<std::uint32_t>& chosen) {
  return std::all_of(chosen.begin(), chosen.end(),
                     [&](std::uint32_t c) { return c == chosen.front(); });
}

std::optional<double> algorithm_coverage(const PolygonResult& result, std::uint32_t robots) {
  double sum = 0;
  for (const Method method : candidate_methods) {
    const Measurement* m = find(result, method, robots);
    if (!m) return std::nullopt;
    sum += m->coverage;
  }
  return sum / static_cast<double>(std::size(candidate_methods));
}

// The largest measured number of robots in teams of two.
std::uint32_t most_in_teams(const PolygonResult& result) {
  std::uint32_t most = 0;
  for (const Measurement& m : result.measurements)
    if (m.method == Method::area) most = std::max(most, m.robots);
  return most;
}

}  // namespace

const Measurement* find(const PolygonResult& result, Method method, std::uint32_t robots) {
  // Rows are sorted by method, then by robots.
  const auto at = std::lower_bound(
      result.measurements.begin(), result.measurements.end(), std::pair(method, robots),
      [](const Measurement& m, auto key) { return std::pair(m.method, m.robots) < key; });
  const bool found =
      at != result.measurements.end() && at->method == method && at->robots == robots;
  return found ? &*at : nullptr;
}

Count same_choice(const std::vector<PolygonResult>& results, std::uint32_t teams,
                  std::size_t most_vertices) {
  Count count;
  for (const PolygonResult& result : results) {
    if (result.vertices > most_vertices) continue;
    const auto chosen = choices(result, teams);
    if (!chosen) continue;
    if (teams > 2 && !all_same(*choices(result, teams - 1))) continue;
    ++count.of;
    if (all_same(*chosen)) ++count.yes;
  }
  return count;
}

Count alike_coverage(const std::vector<PolygonResult>& results, double difference) {
  Count count;
  for (const PolygonResult& result : results) {
    const auto chosen = choices(result, 2);
    if (!chosen || all_same(*chosen)) continue;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Method method : candidate_methods) {
      const double coverage = find(result, method, 4)->coverage;
      least = std::min(least, coverage);
      most = std::max(most, coverage);
    }
    ++count.of;
    if (most - least < difference) ++count.yes;
  }
  return count;
}

std::vector<double> coverage_differences(const std::vector<PolygonResult>& results, Method method) {
  std::vector<double> differences;
  for (const PolygonResult& result : results) {
    double sum = 0;
    int count = 0;
    const std::uint32_t most = most_in_teams(result);
    for (std::uint32_t robots = 4; robots <= most; robots += 2) {
      const std::optional<double> ours = algorithm_coverage(result, robots);
      const Measurement* other = find(result, method, robots);
      if (!ours || !other) continue;
      sum += other->coverage - *ours;
      ++count;
    }
    if (count > 0) differences.push_back(sum / count);
  }
  return differences;
}

std::vector<double> final_coverages(const std::vector<PolygonResult>& results) {
  std::vector<double> coverages;
  for (const PolygonResult& result : results)
    if (const auto covered = algorithm_coverage(result, most_in_teams(result)))
      coverages.push_back(*covered);
  return coverages;
}

std::vector<double> all_coverages(const std::vector<PolygonResult>& results) {
  std::vector<double> coverages;
  for (const PolygonResult& result : results)
    for (const Measurement& m : result.measurements)
      if (m.robots >= 4 && selects_candidates(m.method)) coverages.push_back(m.coverage);
  return coverages;
}

std::optional<Loss> greatest_loss(const std::vector<PolygonResult>& results, std::uint32_t robots) {
  std::optional<Loss> greatest;
  for (const PolygonResult& moved : results) {
    const std::size_t name = moved.polygon.rfind("-moved");
    if (name == std::string::npos) continue;
    const auto outline = std::find_if(
        results.begin(), results.end(),
        [&](const PolygonResult& other) { return other.polygon == moved.polygon.substr(0, name); });
    if (outline == results.end()) continue;
    const Measurement *before = find(*outline, Method::area, robots),
                      *after = find(moved, Method::area, robots);
    if (!before || !after) continue;
    if (!greatest || before->coverage - after->coverage > greatest->before - greatest->after)
      greatest = {moved.polygon, before->coverage, after->coverage};
  }
  return greatest;
}

Count closed(const std::vector<PolygonResult>& results, Closed closed) {
  Count count;
  for (const PolygonResult& result : results) {
    count.of += can_close(result, closed);
    count.yes += std::any_of(
        result.measurements.begin(), result.measurements.end(),
        [&](const Measurement& m) { return selects_candidates(m.method) && m.*closed > 0; });
  }
  return count;
}

Count closed_with(const std::vector<PolygonResult>& results, Closed closed, Method method,
                  std::uint32_t robots, std::size_t most_vertices) {
  Count count;
  for (const PolygonResult& result : results) {
    const Measurement* m = find(result, method, robots);
    if (!m || result.vertices > most_vertices) continue;
    count.of += can_close(result, closed);
    count.yes += m->*closed > 0;
  }
  return count;
}

Lost closure_lost(const std::vector<PolygonResult>& results, Closed closed, Method method) {
  Lost lost;
  std::set<std::uint32_t> robots;
  for (const PolygonResult& result : results) {
    const std::uint32_t most = most_in_teams(result);
    for (std::uint32_t number = 4; number <= most; number += 2) {
      const Measurement *before = find(result, method, number - 2),
                        *after = find(result, method, number);
      if (!before || !after || before->*closed == 0) continue;
      ++lost.steps.of;
      if (after->*closed >= before->*closed) continue;
      ++lost.steps.yes;
      robots.insert(number);
    }
  }
  lost.robots.assign(robots.begin(), robots.end());
  return lost;
}

}  // namespace evenlift::experiment
