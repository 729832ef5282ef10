// The load that each robot bears (algorithm.md, Loads; thesis 5.3).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "evenlift/chords.h"

namespace evenlift {

struct Team {
  Chord chord;
  std::array<double, 2> loads{};  // of r1 and r2, in the unit of the weight; their sum is the
                                  // weight divided by the number of teams
};

struct LoadSummary {
  double min = 0, mean = 0, max = 0;  // over all robots
  double spread = 0;                  // max - min (figure 5.3)
  double max_share = 0.5;             // greatest share of its team's load, in [0.5, 1) (figure 5.5)
};

// The teams with their loads; `weight` > 0. Each team bears an equal part of the weight, and by the
// law of the lever r1 bears the fraction |C r2| / |r1 r2| of its team's part. O(teams).
std::vector<Team> distribute_weight(const std::vector<Chord>& chords, double weight);

// Summarizes the loads of all robots; nothing if there are no teams. O(teams).
std::optional<LoadSummary> summarize_loads(const std::vector<Team>& teams);

}  // namespace evenlift
