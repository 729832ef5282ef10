// Compares the core with the exact oracle on one small polygon: candidates and their order, teams,
// verdicts.
#pragma once

#include <string>

#include "shapes/small_polygons.h"

namespace against_oracle {

using small_polygons::Case;

struct Finding {
  std::string differences;  // a line for each
  int compared = 0;         // equal angles: compared teams
  // Differences that do not count: the oracle shows that a tolerance, or a jump of the farthest
  // point, decided by a hair.
  int passed_over = 0;
};

/// The case as text, to reproduce a difference.
std::string text(const Case& c);

/// Candidates, teams and verdicts by the case's metric.
Finding compare_placement(const Case& c);

/// Whether both refuse the case or neither does.
Finding compare_refusal(const Case& c);

Finding compare_vertex_chords(const Case& c);

/// At equal angles.
Finding compare_distributed(const Case& c);

}  // namespace against_oracle
