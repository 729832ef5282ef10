#include "balanced/triples.h"

namespace evenlift::balanced {

namespace {

// How many of the three pairs must be neighbours along the outline. Beyond 24 robots, two pairs
// cost 1 percentage point more coverage than one but take a twentieth of the time.
std::uint32_t neighbours_needed(std::uint32_t robots) {
  return robots <= 12 ? 0 : robots <= 24 ? 1 : 2;
}

}  // namespace

std::vector<Triple> triples_of(std::uint32_t robots) {
  const std::uint32_t needed = neighbours_needed(robots);
  const auto one_if = [](bool neighbours) { return neighbours ? 1u : 0u; };
  std::vector<Triple> triples;
  for (std::uint32_t i = 0; i < robots; ++i)
    for (std::uint32_t j = i + 1; j < robots; ++j)
      for (std::uint32_t k = j + 1; k < robots; ++k)
        if (one_if(j == i + 1) + one_if(k == j + 1) + one_if(k == i + robots - 1) >= needed)
          triples.push_back({i, j, k});
  return triples;
}

std::vector<LiftingPoint> others(const std::vector<LiftingPoint>& robots, const Triple& triple) {
  std::vector<LiftingPoint> others;
  others.reserve(robots.size());
  for (std::uint32_t i = 0; i < robots.size(); ++i)
    if (i != triple[0] && i != triple[1] && i != triple[2]) others.push_back(robots[i]);
  return others;
}

}  // namespace evenlift::balanced
