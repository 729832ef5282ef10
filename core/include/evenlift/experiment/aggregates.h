// Averages over the polygons, as in figures 5.3 to 5.8 and 5.11 of the thesis.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/experiment/results.h"

namespace evenlift::experiment {

struct Statistics {
  double mean = 0;
  std::optional<double> deviation;  // standard deviation with divisor n - 1; empty for one value
};

// The statistics of one or more values, added in order. O(n).
Statistics statistics(const std::vector<double>& values);

// The averages for a method and a number of robots, over all polygons measured with both. Teams of
// two are measured only on polygons where the algorithm can place that number of teams.
struct Aggregate {
  Method method = Method::area;
  std::uint32_t robots = 0;
  std::uint32_t polygons = 0;  // at least 1
  Statistics spread;           // kg (figures 5.3, 5.4)
  Statistics load_max;         // kg
  Statistics max_share;        // 0.5 .. 1 (figures 5.5, 5.6)
  Statistics coverage;         // 0 .. 1 (figures 5.7, 5.8)
  double closed = 0;           // share of polygons in form closure, 0 .. 1
  double held_clear = 0;       // `closed` if only contacts far enough from corners count
  // `closable` is the number of these polygons for which can_close() is true for form closure.
  // `form_closure` is the share of them that this method brings into form closure with this number
  // of robots (figure 5.11). `no_area_possible` and `no_area` are the same for the thesis's own,
  // weaker test.
  std::uint32_t closable = 0, no_area_possible = 0;
  std::optional<double> form_closure, no_area;
};

// Selects one of two tests: form closure, or the thesis's own test.
using Closed = double Measurement::*;

// Whether teams of two, by any method and in any number, pass the test. Balanced robots do not
// count, so that figure 5.11 leaves out the same polygons as the thesis. O(rows).
bool can_close(const PolygonResult& result, Closed closed);

// The aggregates, sorted by method, then by number of robots. O(rows).
std::vector<Aggregate> aggregate(const std::vector<PolygonResult>& results);

struct SetAggregates {
  std::string set;
  std::vector<Aggregate> aggregates;
};

// One row for each aggregate, under a heading; missing values are empty. O(rows).
std::string aggregates_csv(const std::vector<SetAggregates>& sets);

// The aggregate of this method and number of robots; null if there is no such aggregate. O(rows).
const Aggregate* find(const std::vector<Aggregate>& aggregates, Method method,
                      std::uint32_t robots);

}  // namespace evenlift::experiment
