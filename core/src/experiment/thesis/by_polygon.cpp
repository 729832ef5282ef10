#include "experiment/thesis/by_polygon.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"

namespace evenlift::experiment {
namespace {

using Rows = std::vector<Aggregate>;

constexpr const char* nothing =
    "No polygon of this set has a candidate, so no teams of two were measured.";

// "1.20 kg by area, 1.30 kg by circle and 12.5 kg at equal angles": every method with a value.
template <class Write>
std::string by_every_method(const Rows& rows, std::uint32_t robots, Pick pick, Write write) {
  std::vector<std::string> items;
  for (const Method method : all_methods) {
    const Aggregate* a = find(rows, method, robots);
    const std::optional<double> value = a ? pick(*a) : std::nullopt;
    if (value) items.push_back(write(*value) + " " + by(method));
  }
  return listed(items);
}

std::string times(const Range& range) {
  const std::string least = fixed(range.least, 1), most = fixed(range.most, 1);
  return least == most ? least : say("{least} to {most}", {least, most});
}

// Names the methods whose values vary most and least between the polygons, by the greatest
// deviation over all numbers of robots.
template <class Write>
std::string deviations(const Rows& rows, std::uint32_t most_robots, Pick pick, Write write) {
  const Aggregate *most = nullptr, *least = nullptr;
  for (const Method method : all_methods) {
    const Aggregate* held = nullptr;
    for (const Aggregate& a : rows)
      if (a.method == method && a.robots <= most_robots && pick(a) &&
          (!held || *pick(a) > *pick(*held)))
        held = &a;
    if (!held) continue;
    if (!most || *pick(*held) > *pick(*most)) most = held;
    if (!least || *pick(*held) < *pick(*least)) least = held;
  }
  if (!most) return "One polygon alone has no standard deviation.";
  if (*pick(*most) <= 0) return "The value is the same for all these polygons, with every method.";
  return say(
      "Polygons differ most from each other when robots are placed {how} (standard deviation up to "
      "{most}, with {robots} robots) and least {other} (up to {least}, with {number} robots).",
      {by(most->method), write(*pick(*most)), most->robots, by(least->method), write(*pick(*least)),
       least->robots});
}

// The coverage by the most balanced robots measured, if these are fewer than `robots`.
std::string fewer_in_balance(const Rows& rows, std::uint32_t robots) {
  const Aggregate* most = nullptr;
  for (const Aggregate& a : rows)
    if (a.method == Method::balanced && (!most || a.robots > most->robots)) most = &a;
  if (!most || most->robots >= robots) return "";
  return " " + say("{robots} robots in balance cover {coverage}.",
                   {most->robots, in_percent(most->coverage.mean)});
}

std::string lead_in_words(double lead, Method method) {
  return say(lead < 0 ? "{points} percentage points less than {how}"
                      : "{points} percentage points more than {how}",
             {fixed(100 * std::fabs(lead), 1), by(method)});
}

}  // namespace

std::string in_unit(double value, const std::string& unit) {
  return fixed(value, 2) + "\u00A0" + unit;
}
std::string in_kg(double value) { return in_unit(value, "kg"); }
std::string in_percent(double share) { return fixed(100 * share, 1) + "\u00A0%"; }

std::string by(Method method) {
  switch (method) {
    case Method::area:
      return say("by area");
    case Method::circle:
      return say("by circle");
    case Method::distance:
      return say("by distance");
    case Method::distributed:
      return say("at equal angles");
    case Method::random:
      return say("at random");
    case Method::balanced:
      return say("in balance");
    case Method::given:  // no experiment places them
      break;
  }
  return {};
}

std::string spread_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  const std::uint32_t robots = std::min<std::uint32_t>(4, most_robots);
  std::string text =
      say("With {robots} robots the spread of loads is {values}, averaged over the polygons.",
          {robots, by_every_method(rows, robots, pick_spread, in_kg)});
  const auto distributed = spread_ratio(rows, Method::distributed, most_robots);
  const auto random = spread_ratio(rows, Method::random, most_robots);
  if (distributed && random)
    text +=
        " " + say("From 2 to {robots} robots the spread at equal angles is {times} times the "
                  "spread of the algorithm (the mean of its three metrics), and at random {other} "
                  "times.",
                  {most_robots, times(*distributed), times(*random)});
  return text;
}

std::string spread_deviation_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  return deviations(
      rows, most_robots, [](const Aggregate& a) { return a.spread.deviation; }, in_kg);
}

std::string share_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  const std::uint32_t robots = std::min<std::uint32_t>(20, most_robots);
  return say(
      "With {robots} robots the robot with the larger share of its team’s load carries {values}, "
      "averaged over the polygons; an even half is 50\u00A0%, as for any two balanced robots.",
      {robots, by_every_method(rows, robots, pick_share, in_percent)});
}

std::string share_deviation_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  return deviations(
      rows, most_robots, [](const Aggregate& a) { return a.max_share.deviation; }, in_percent);
}

std::string coverage_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  if (most_robots == 2) return "One team stands on a line, which covers nothing.";
  const std::uint32_t robots = std::min<std::uint32_t>(12, most_robots);
  std::string text = say("With {robots} robots the lifting base covers {values}.",
                         {robots, by_every_method(rows, robots, pick_coverage, in_percent)}) +
                     fewer_in_balance(rows, robots);
  const auto distributed = coverage_lead(rows, Method::distributed, most_robots);
  const auto random = coverage_lead(rows, Method::random, most_robots);
  if (distributed && random)
    text +=
        " " + say("From 4 to {robots} robots the algorithm covers on average {lead}, and {other}.",
                  {most_robots, lead_in_words(*distributed, Method::distributed),
                   lead_in_words(*random, Method::random)});
  return text;
}

std::string coverage_deviation_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  return deviations(
      rows, most_robots, [](const Aggregate& a) { return a.coverage.deviation; }, in_percent);
}

std::string closure_sentence(const Rows& rows, std::uint32_t most_robots) {
  if (most_robots == 0) return nothing;
  const Aggregate* first = find(rows, Method::area, 2);
  if (!first || first->closable == 0)
    return "No teams of two bring any of these polygons into form closure.";
  const std::uint32_t robots = std::min<std::uint32_t>(8, most_robots);
  return say(
      "With {robots} robots, {values} are in form closure, of the polygons that teams of two can "
      "bring into it.",
      {robots, by_every_method(rows, robots, pick_closure, in_percent)});
}

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
