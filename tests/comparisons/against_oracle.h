// Compares the core with the exact oracle on one small polygon: the same candidates in the same
// order, the same teams, the same verdicts.
#pragma once

#include <string>

#include "shapes/small_polygons.h"

namespace against_oracle {

using small_polygons::Case;

struct Finding {
  std::string differences;  // a line for each; empty if core and oracle agree
  int compared = 0;         // equal angles: the number of compared teams
  // The number of differences that do not count: the oracle shows that a tolerance, or a jump of
  // the farthest point, decided by a hair.
  int passed_over = 0;
};

/// The case as text, for a file that reproduces a difference.
std::string text(const Case& c);

/// Candidates, teams and verdicts by the case's own metric.
Finding compare_placement(const Case& c);

/// Whether the core refuses the case if and only if the oracle does.
Finding compare_refusal(const Case& c);

/// The list of vertex-chords.
Finding compare_vertex_chords(const Case& c);

/// The teams at equal angles.
Finding compare_distributed(const Case& c);

}  // namespace against_oracle
