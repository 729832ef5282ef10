#include "optimum/triangles.h"

#include <algorithm>
#include <cmath>

#include "polygon/clip.h"

namespace evenlift::optimum {
namespace {

// The area of a ring in the triangle a, b, C (the origin).
double area_within(const Points& ring, const Vec2& a, const Vec2& b) {
  if (!(cross(a, b) > 0)) return 0;
  return std::fabs(area_left_of_both(clip_left(ring, a, b), b, Vec2{}, a));
}

}  // namespace

Triangles::Triangles(const PolygonWithHoles& object, const Vec2& centre,
                     const std::vector<Candidate>& candidates)
    : chords_(static_cast<std::uint32_t>(candidates.size())) {
  Points ring, ends(2 * candidates.size());
  for (const Vec2& v : object.boundary()) ring.push_back(v - centre);
  for (std::uint32_t i = 0; i < chords_; ++i) {
    ends[i] = candidates[i].chord.r2.position - centre;
    ends[chords_ + i] = candidates[i].chord.r1.position - centre;
  }
  shares_.assign(ends.size() * (chords_ + std::size_t{1}), 0);
  for (std::uint32_t from = 0; from < ends.size(); ++from)
    for (std::uint32_t steps = 1; steps < chords_; ++steps)
      shares_[from * (chords_ + std::size_t{1}) + steps] =
          area_within(ring, ends[from], ends[(from + steps) % ends.size()]) / object.area();
}

}  // namespace evenlift::optimum
