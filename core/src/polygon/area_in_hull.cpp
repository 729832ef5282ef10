#include "polygon/area_in_hull.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "exact/pseudo_angle.h"

namespace evenlift {
namespace {

// The sides of the polygon as seen from a point inside, which is the origin here. The area is that
// of a closed curve: the ring, with all parts beyond a side pulled to the side along the rays to the
// origin.
class Fan {
 public:
  explicit Fan(const Points& hull) {
    for (const Vec2& corner : hull) origin_ += corner / static_cast<double>(hull.size());
    for (const Vec2& corner : hull) corners_.push_back(corner - origin_);
    const auto first = std::min_element(
        corners_.begin(), corners_.end(),
        [](const Vec2& a, const Vec2& b) { return pseudo_angle(a) < pseudo_angle(b); });
    std::rotate(corners_.begin(), first, corners_.end());
    for (const Vec2& corner : corners_) angles_.push_back(pseudo_angle(corner));
  }

  const Vec2& origin() const { return origin_; }

  // Twice the area between the origin and the edge from a to b, within the polygon.
  double below(const Vec2& a, const Vec2& b) const {
    const double turn = cross(a, b);
    if (turn < 0) return -below(b, a);
    if (!(turn > 0)) return 0;
    double sum = 0;
    Vec2 from = a;
    std::size_t sector = sector_of(a);
    for (std::size_t passed = 0; passed < corners_.size(); ++passed) {
      const Vec2& corner = corners_[next(sector)];
      const double after_a = cross(a, corner), before_b = cross(corner, b);
      if (!(before_b > 0) || after_a < 0) break;
      const Vec2 to = a + after_a / (after_a + before_b) * (b - a);
      sum += in_sector(sector, from, to);
      from = to;
      sector = next(sector);
    }
    return sum + in_sector(sector, from, b);
  }

 private:
  std::size_t next(std::size_t sector) const {
    return sector + 1 == corners_.size() ? 0 : sector + 1;
  }

  // Sector i lies between corners i and i + 1.
  std::size_t sector_of(const Vec2& point) const {
    const auto after = std::upper_bound(angles_.begin(), angles_.end(), pseudo_angle(point));
    return after == angles_.begin() ? corners_.size() - 1
                                    : static_cast<std::size_t>(after - angles_.begin()) - 1;
  }

  double in_sector(std::size_t sector, const Vec2& from, const Vec2& to) const {
    const Vec2 &corner = corners_[sector], side = corners_[next(sector)] - corner;
    const double whole = cross(side, -corner);  // of the origin; above 0
    const double at_from = whole + cross(side, from), at_to = whole + cross(side, to);
    const auto pulled = [&](const Vec2& point, double at) { return whole / (whole - at) * point; };
    if (at_from >= 0 && at_to >= 0) return cross(from, to);
    if (at_from <= 0 && at_to <= 0) return cross(pulled(from, at_from), pulled(to, at_to));
    const Vec2 on_side = from + at_from / (at_from - at_to) * (to - from);
    return at_from > 0 ? cross(from, on_side) + cross(on_side, pulled(to, at_to))
                       : cross(pulled(from, at_from), on_side) + cross(on_side, to);
  }

  Vec2 origin_;
  Points corners_;
  std::vector<double> angles_;
};

}  // namespace

double doubled_area_in_hull(const Points& ring, const Points& hull) {
  const Fan fan(hull);
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += fan.below(ring[i] - fan.origin(), ring[i + 1 == ring.size() ? 0 : i + 1] - fan.origin());
  return sum;
}

}  // namespace evenlift
