// Lists the candidates for teams under a triangle: chords whose arms differ by at most a fifth.
#include <cstdio>

#include "evenlift/candidates.h"
#include "evenlift/polygon.h"

int main() {
  const auto polygon = evenlift::Polygon::create({{0, 0}, {6, 0}, {1, 4}});
  if (!polygon) return 1;
  const auto candidates = evenlift::find_candidates(*polygon, polygon->centroid(), 0.8);
  if (!candidates) return 1;
  for (const evenlift::Candidate& candidate : *candidates) {
    const evenlift::Vec2 &a = candidate.chord.r1.position, &b = candidate.chord.r2.position;
    std::printf("(%.2f, %.2f) to (%.2f, %.2f), ratio %.3f, %s\n", a.x, a.y, b.x, b.y,
                candidate.chord.ratio, evenlift::name(candidate.kind).data());
  }
}
