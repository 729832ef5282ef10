// What chapter 5 counts polygon by polygon, not from averages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// A number of cases out of all cases.
struct Count {
  std::uint32_t yes = 0, of = 0;
};

// The measurement of a method with a number of robots, or null. O(rows).
const Measurement* find(const PolygonResult& result, Method method, std::uint32_t robots);

// Polygons with candidates for `teams` on which all that choose among candidates choose the same
// last team; with more than two teams, of those on which they chose the same one before, too (5.4).
// Only polygons with up to `most_vertices`.
Count same_choice(const std::vector<PolygonResult>& results, std::uint32_t teams,
                  std::size_t most_vertices = max_vertices);

// Counts the polygons on which the three metrics choose different second teams, and among them
// those on which the coverages still differ by less than `difference` of the polygon.
Count alike_coverage(const std::vector<PolygonResult>& results, double difference);

// For each polygon with two teams or more the mean, over 2 .. its most teams, of the coverage of
// the method less that of the algorithm (the mean of its metrics).
std::vector<double> coverage_differences(const std::vector<PolygonResult>& results, Method method);

// For each polygon with candidates the algorithm's coverage with the most teams.
std::vector<double> final_coverages(const std::vector<PolygonResult>& results);

// The algorithm's coverage in every measurement with two teams or more (one covers nothing): of
// each polygon, metric, and number of teams.
std::vector<double> all_coverages(const std::vector<PolygonResult>& results);

// The greatest loss of coverage (method area) with so many robots from a polygon NAME to NAME-moved
// or NAME-moved-1, NAME-moved-2 ..., and the name of the latter; none without such a couple.
struct Loss {
  std::string polygon;
  double before = 0, after = 0;
};
std::optional<Loss> greatest_loss(const std::vector<PolygonResult>& results, std::uint32_t robots);

// Polygons that some method of the thesis closes with some number of teams, and that one which
// chooses among candidates closes, too. (With all candidates placed these are one.)
Count closed(const std::vector<PolygonResult>& results, Closed closed);

// Polygons with up to `most_vertices` that can be closed and on which the method can place so many
// robots, and those that it closes with them.
Count closed_with(const std::vector<PolygonResult>& results, Closed closed, Method method,
                  std::uint32_t robots, std::size_t most_vertices);

// Steps from one number of teams to the next at which a polygon in form closure loses it; and the
// numbers of robots after the step at which that happens, each once, rising.
struct Lost {
  Count steps;
  std::vector<std::uint32_t> robots;
};
Lost closure_lost(const std::vector<PolygonResult>& results, Closed closed, Method method);

}  // namespace evenlift::experiment
