#include "output/svg/svg_paper.h"

#include <algorithm>
#include <cmath>

#include "output/svg/svg_style.h"

namespace evenlift::svg {

Paper::Paper(const Points& vertices) {
  Vec2 low = vertices[0], high = vertices[0];
  for (const Vec2& v : vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Vec2 size = high - low;
  scale = std::min(largest_width / size.x(), largest_height / size.y());
  middle = low + size / 2;
  width = std::max(smallest_width, std::ceil(size.x() * scale) + 2 * margin);
  height = std::max(smallest_height, std::ceil(size.y() * scale) + 2 * margin);
}

Vec2 Paper::operator()(const Vec2& p) const {
  return {width / 2 + (p.x() - middle.x()) * scale, height / 2 - (p.y() - middle.y()) * scale};
}

Points Paper::operator()(const Points& points) const {
  Points mapped;
  mapped.reserve(points.size());
  for (const Vec2& p : points) mapped.push_back((*this)(p));
  return mapped;
}

Points clipped(Points area, const Paper& paper) {
  // Each side of the ground as a x + b y + c >= 0.
  const double sides[][3] = {{1, 0, 0}, {-1, 0, paper.width}, {0, 1, 0}, {0, -1, paper.height}};
  for (const auto& [a, b, c] : sides) {
    Points kept;
    for (std::size_t i = 0; i < area.size(); ++i) {
      const Vec2& p = area[i];
      const Vec2& q = area[i + 1 == area.size() ? 0 : i + 1];
      const double p_depth = a * p.x() + b * p.y() + c, q_depth = a * q.x() + b * q.y() + c;
      if (p_depth >= 0) kept.push_back(p);
      if ((p_depth < 0) != (q_depth < 0))
        kept.emplace_back(p + (q - p) * (p_depth / (p_depth - q_depth)));
    }
    area = std::move(kept);
  }
  return area;
}

Points visible(const Points& outline) {
  constexpr double resolution = 0.04;
  Points kept;
  for (const Vec2& p : outline)
    if (kept.empty() || (p - kept.back()).cwiseAbs().maxCoeff() > resolution) kept.push_back(p);
  return kept;
}

}  // namespace evenlift::svg
