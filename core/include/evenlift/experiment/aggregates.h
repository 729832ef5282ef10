// Averages over the polygons: what figures 5.3 to 5.8 and 5.11 of the thesis show.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/experiment/results.h"

namespace evenlift::experiment {

struct Statistics {
  double mean = 0;
  std::optional<double> deviation;  // standard, of a sample (divided by n - 1); none for one value
};

// Mean and deviation of at least one value, added up in order. O(n).
Statistics statistics(const std::vector<double>& values);

// The averages of a method with a number of robots, over all polygons on which the method was
// measured with so many: of methods that place teams of two, those on which the algorithm can place
// that many teams, too.
struct Aggregate {
  Method method = Method::area;
  std::uint32_t robots = 0;
  std::uint32_t polygons = 0;  // at least 1
  Statistics spread;           // kg (figures 5.3, 5.4)
  Statistics load_max;         // kg
  Statistics max_share;        // 0.5 .. 1 (5.5, 5.6)
  Statistics coverage;         // 0 .. 1 (5.7, 5.8)
  double closed = 0;           // part of these polygons in form closure, 0 .. 1
  double held_clear = 0;       // and by contacts that are clear of corners, 0 .. 1
  // `closable` is the number of polygons that at least one placement of teams of two closes, by any
  // method, and `form_closure` the fraction of those that this method closes (figure 5.11). The
  // other two are the same by the thesis's own, weaker test.
  std::uint32_t closable = 0, no_area_possible = 0;
  std::optional<double> form_closure, no_area;
};

// What counts as closed: form closure, or the thesis's own test.
using Closed = double Measurement::*;

// Whether some placement of teams of two on the polygon is closed. Balanced robots do not count, so
// that what is left out is what the thesis leaves out. O(rows).
bool can_close(const PolygonResult& result, Closed closed);

// The aggregates of one set's results, by method, then by robots. O(rows).
std::vector<Aggregate> aggregate(const std::vector<PolygonResult>& results);

// The aggregates of one set.
struct SetAggregates {
  std::string set;
  std::vector<Aggregate> aggregates;
};

// One row for each aggregate, under a heading; deviations and form_closure are empty where there
// are none. O(rows).
std::string aggregates_csv(const std::vector<SetAggregates>& sets);

// The aggregate of a method and number of robots, or null. O(rows).
const Aggregate* find(const std::vector<Aggregate>& aggregates, Method method,
                      std::uint32_t robots);

}  // namespace evenlift::experiment
