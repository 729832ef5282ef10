#include "output/svg/svg_paper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/plane.h"
#include "output/svg/svg_style.h"

namespace evenlift::svg {

Paper::Paper(const Points& vertices, double share) {
  const Box box = bounding_box(vertices);
  const Vec2 size = box.size();
  scale = share * std::min(largest_width / size.x, largest_height / size.y);
  middle = box.middle();
  width = std::max(share * smallest_width, std::ceil(size.x * scale) + 2 * margin);
  height = std::max(share * smallest_height, std::ceil(size.y * scale) + 2 * margin);
}

Vec2 Paper::operator()(const Vec2& p) const {
  return {width / 2 + (p.x - middle.x) * scale, height / 2 - (p.y - middle.y) * scale};
}

Points Paper::operator()(const Points& points) const {
  Points mapped;
  mapped.reserve(points.size());
  for (const Vec2& p : points) mapped.push_back((*this)(p));
  return mapped;
}

Points clipped(Points area, const Paper& paper) {
  return clip(std::move(area), Box{Vec2{}, Vec2(paper.width, paper.height)});
}

Points visible(const Points& outline) {
  constexpr double resolution = 0.04;
  Points kept;
  for (const Vec2& p : outline)
    if (kept.empty() || max_norm(p - kept.back()) > resolution) kept.push_back(p);
  return kept;
}

}  // namespace evenlift::svg
