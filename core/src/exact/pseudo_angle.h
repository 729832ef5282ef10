// Order by direction as seen from C, without trigonometry.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// In [0, 4), growing counter-clockwise from the positive x axis; opposite directions differ by 2.
// The rounding is far below the tolerance with which directions agree. O(1).
inline double direction_key(const Vec2& u) {
  const double size = std::fabs(u.x()) + std::fabs(u.y());
  if (size == 0) return 0;
  const double part = u.y() / size;
  if (u.x() < 0) return 2 - part;
  if (u.y() >= 0) return part;
  const double key = 4 + part;
  return key < 4 ? key : 0;  // a part below the last place of 4 rounds up to the full turn
}

// The key `key` counted from `origin`, in [-1, 3): what lies a little before the origin is
// negative.
inline double key_from(double origin, double key) {
  double difference = key - origin;
  if (difference < -1) difference += 4;
  if (difference >= 3) difference -= 4;
  return difference;
}

// Where C sees an item that is visited by for_each_between.
enum class SeenAt : std::uint8_t { first_corner, between, second_corner };

// Calls visit(item, seen_at) for the items that C sees between two corners of H or in the direction
// of one of them, in counter-clockwise order. A direction that agrees with a corner's is the
// corner's. `items` are sorted by key, seen(item) has `position` (relative to C) and `key`.
// O(log m) besides the visits.
template <class Items, class See, class Visit>
void for_each_between(const Items& items, See seen, const Vec2& h1, const Vec2& h2, Visit visit) {
  const double margin = 4 * tau;  // keys of directions that agree differ by less
  const double key1 = direction_key(h1);
  const double width = key_from(key1, direction_key(h2));
  const double start = key1 - margin < 0 ? key1 - margin + 4 : key1 - margin;
  const auto first =
      std::lower_bound(items.begin(), items.end(), start,
                       [&](const auto& item, double key) { return seen(item).key < key; });
  const std::size_t n = items.size(), offset = static_cast<std::size_t>(first - items.begin());
  for (std::size_t k = 0; k < n; ++k) {
    const auto& item = items[offset + k < n ? offset + k : offset + k - n];
    const double key = key_from(key1, seen(item).key);
    if (key > width + margin) break;
    const Vec2& position = seen(item).position;
    if (directions_agree(h1, position)) {
      visit(item, SeenAt::first_corner);
    } else if (directions_agree(h2, position)) {
      visit(item, SeenAt::second_corner);
    } else if (key >= 0 && key < width) {
      visit(item, SeenAt::between);
    }
  }
}

}  // namespace evenlift
