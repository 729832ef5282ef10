#include "import/joining/nesting.h"

#include <algorithm>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "import/joining/point_order.h"

namespace evenlift {
namespace {

// The vertices from the least one on, counter-clockwise, by which repeated outlines are found.
Points in_order(Points points) {
  if (signed_area(points) < 0) std::reverse(points.begin(), points.end());
  std::rotate(points.begin(), std::min_element(points.begin(), points.end(), is_before),
              points.end());
  return points;
}

struct OutlineInOrder {
  std::size_t number = 0;
  Points key;
  Box box;
  double area = 0;
};

bool before(const OutlineInOrder& a, const OutlineInOrder& b) {
  if (a.area != b.area) return a.area > b.area;
  return std::lexicographical_compare(a.key.begin(), a.key.end(), b.key.begin(), b.key.end(),
                                      is_before);
}

// A hole has no point on the outline around it. Of long outlines some vertices are looked at.
bool contains(const OutlineInOrder& outer, const OutlineInOrder& inner) {
  if ((inner.box.low.array() < outer.box.low.array()).any() ||
      (inner.box.high.array() > outer.box.high.array()).any())
    return false;
  constexpr std::size_t most_looked_at = 256;
  const std::size_t step = inner.key.size() / most_looked_at + 1;
  const double touching = 1e-9 * outer.box.diagonal();
  for (std::size_t i = 0; i < inner.key.size(); i += step) {
    const Vec2& p = inner.key[i];
    if (!inside(outer.key, p)) return false;
    for (std::size_t j = 0; j < outer.key.size(); ++j) {
      const Vec2& next = outer.key[j + 1 == outer.key.size() ? 0 : j + 1];
      if (length(p - nearest_on_segment(outer.key[j], next, p)) <= touching) return false;
    }
  }
  return true;
}

}  // namespace

Nesting nest(const std::vector<const Points*>& outlines) {
  std::vector<OutlineInOrder> all;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    OutlineInOrder outline{i, in_order(*outlines[i]), {}, 0};
    outline.box = bounding_box(outline.key);
    outline.area = signed_area(outline.key);
    all.push_back(std::move(outline));
  }
  std::stable_sort(all.begin(), all.end(), before);
  Nesting nesting;
  std::vector<OutlineInOrder> kept;
  for (OutlineInOrder& outline : all) {
    if (!kept.empty() && kept.back().key == outline.key)
      ++nesting.repeated;
    else
      kept.push_back(std::move(outline));
  }
  // The smallest outline around each, which comes last among those before it.
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> around(kept.size(), none), depth(kept.size(), 0), shape(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t j = i; j-- > 0 && around[i] == none;)
      if (contains(kept[j], kept[i])) around[i] = j;
    if (around[i] != none) depth[i] = depth[around[i]] + 1;
    if (depth[i] % 2 == 0) {
      shape[i] = nesting.shapes.size();
      nesting.shapes.push_back({kept[i].number, {}});
    } else {
      nesting.shapes[shape[around[i]]].holes.push_back(kept[i].number);
      ++nesting.holes;
    }
  }
  return nesting;
}

}  // namespace evenlift
