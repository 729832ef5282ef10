// The counts of chapter 5 over single polygons, not over averages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/experiment/aggregates.h"

namespace evenlift::experiment {

struct Count {
  std::uint32_t yes = 0, of = 0;
};

// Null if not measured. O(log rows).
const Measurement* find(const PolygonResult& result, Method method, std::uint32_t robots);

// Of the polygons with up to `most_vertices` and candidates for `teams` teams: those on which all
// metrics choose the same last team. With more than two teams, a polygon counts only if they chose
// the same preceding team (5.4).
Count same_choice(const std::vector<PolygonResult>& results, std::uint32_t teams,
                  std::size_t most_vertices = max_vertices);

// Of the polygons on which the three metrics choose different second teams: those on which the
// coverages still differ by less than `difference` of the polygon.
Count alike_coverage(const std::vector<PolygonResult>& results, double difference);

// For each polygon with two teams or more: the method's coverage less the algorithm's (the mean of
// its metrics), averaged over all numbers of teams from 2 on.
std::vector<double> coverage_differences(const std::vector<PolygonResult>& results, Method method);

// For each polygon with candidates: the algorithm's coverage with the most teams.
std::vector<double> final_coverages(const std::vector<PolygonResult>& results);

// The algorithm's coverage for each polygon, metric, and number of teams from two on (one team
// covers nothing).
std::vector<double> all_coverages(const std::vector<PolygonResult>& results);

// The greatest loss of coverage (method area) with `robots` robots from a polygon NAME to
// NAME-moved or NAME-moved-1, NAME-moved-2 ..., and the latter's name; nothing without such
// polygons.
struct Loss {
  std::string polygon;
  double before = 0, after = 0;
};
std::optional<Loss> greatest_loss(const std::vector<PolygonResult>& results, std::uint32_t robots);

// Of the polygons on which some thesis method passes the test with some number of teams: those on
// which a metric passes it. (With all candidates placed, all metrics agree.)
Count closed(const std::vector<PolygonResult>& results, Closed closed);

// Of the polygons with up to `most_vertices` on which the test can be passed and the method can
// place `robots` robots: those on which these robots pass it.
Count closed_with(const std::vector<PolygonResult>& results, Closed closed, Method method,
                  std::uint32_t robots, std::size_t most_vertices);

// Of the steps from one number of teams to the next that begin with a passed test: those that lose
// it; and the numbers of robots after a loss, each once, ascending.
struct Lost {
  Count steps;
  std::vector<std::uint32_t> robots;
};
Lost closure_lost(const std::vector<PolygonResult>& results, Closed closed, Method method);

}  // namespace evenlift::experiment
