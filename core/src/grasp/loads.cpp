#include "evenlift/loads.h"

#include <algorithm>

namespace evenlift {

std::vector<Team> distribute_weight(const std::vector<Chord>& chords, double weight) {
  std::vector<Team> teams;
  teams.reserve(chords.size());
  const double share = weight / static_cast<double>(chords.size());
  for (const Chord& chord : chords) {
    const double whole = chord.arm1 + chord.arm2;
    teams.push_back({chord, {share * (chord.arm2 / whole), share * (chord.arm1 / whole)}});
  }
  return teams;
}

std::optional<LoadSummary> summarize_loads(const std::vector<Team>& teams) {
  if (teams.empty()) return std::nullopt;
  LoadSummary summary;
  summary.min = summary.max = teams.front().loads[0];
  double sum = 0;
  for (const Team& team : teams) {
    const auto [low, high] = std::minmax(team.loads[0], team.loads[1]);
    summary.min = std::min(summary.min, low);
    summary.max = std::max(summary.max, high);
    summary.max_share = std::max(summary.max_share, high / (low + high));
    sum += low + high;
  }
  summary.mean = sum / static_cast<double>(2 * teams.size());
  summary.spread = summary.max - summary.min;
  return summary;
}

}  // namespace evenlift
