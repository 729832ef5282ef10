// The counts of chapter 5 of the thesis over single polygons, not over averages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

// `of` is the number of polygons or steps that count, and `yes` the number of those with a
// property.
struct Count {
  std::uint32_t yes = 0, of = 0;
};

// The row of a method and a number of robots; null if this was not measured. O(log rows).
const Measurement* find(const PolygonResult& result, Method method, std::uint32_t robots);

// Counts the polygons on which all metrics choose the same last team, of those with up to
// `most_vertices` and with candidates for `teams` teams. With more than two teams, a polygon counts
// only if the metrics chose the same preceding team (5.4).
Count same_choice(const std::vector<PolygonResult>& results, std::uint32_t teams,
                  std::size_t most_vertices = max_vertices);

// Counts the polygons on which the metrics' coverages with two teams differ by less than
// `difference`, of those on which the three metrics choose different second teams.
Count alike_coverage(const std::vector<PolygonResult>& results, double difference);

// The method's coverage less the algorithm's (the mean of its metrics), averaged over all numbers
// of teams from 2 on, for each polygon with two teams or more.
std::vector<double> coverage_differences(const std::vector<PolygonResult>& results, Method method);

// The algorithm's coverage with the most teams, for each polygon with candidates.
std::vector<double> final_coverages(const std::vector<PolygonResult>& results);

// The algorithm's coverage for each polygon, metric, and number of teams from two on (one team
// covers nothing).
std::vector<double> all_coverages(const std::vector<PolygonResult>& results);

// The greatest loss of coverage (method area) with `robots` robots from a polygon NAME to a polygon
// NAME-moved or NAME-moved-1, NAME-moved-2 ...; nothing if there are no such polygons.
struct Loss {
  std::string polygon;  // the name of the moved one
  double before = 0, after = 0;
};
std::optional<Loss> greatest_loss(const std::vector<PolygonResult>& results, std::uint32_t robots);

// Counts the polygons on which a metric passes the test with some number of teams, of those on
// which some method of the thesis passes it. (With all candidates placed, all metrics agree.)
Count closed(const std::vector<PolygonResult>& results, Closed closed);

// Counts the polygons on which the method's `robots` robots pass the test, of those with up to
// `most_vertices` on which the method can place them and the test can be passed (can_close()).
Count closed_with(const std::vector<PolygonResult>& results, Closed closed, Method method,
                  std::uint32_t robots, std::size_t most_vertices);

// How often one more team loses a passed test.
struct Lost {
  Count steps;  // those that lose it, of all steps to one more team from a passed test
  std::vector<std::uint32_t> robots;  // the numbers of robots after a loss, each once, ascending
};
Lost closure_lost(const std::vector<PolygonResult>& results, Closed closed, Method method);

}  // namespace evenlift::experiment
