// Converts polygon coordinates to canvas pixels (y down) and back.
#pragma once

#include <optional>

#include "evenlift/vec.h"

namespace evenlift::view {

// In pixels; the origin is the canvas's top left corner.
struct Rect {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Vec2 middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
  bool operator==(const Rect&) const = default;
  bool contains(const Vec2& p) const {
    return p.x() >= left && p.x() < right && p.y() >= top && p.y() < bottom;
  }
  bool overlaps(const Rect& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

// The part of the segment from a to b in a rectangle (boundary included), as fractions of the way
// from a; nothing if they do not meet. O(1).
struct PartOfSegment {
  double from = 0, to = 1;
};
std::optional<PartOfSegment> part_within(const Rect& rect, const Vec2& a, const Vec2& b);

struct Camera {
  Vec2 centre = Vec2::Zero();  // polygon coordinates at `anchor`
  Vec2 anchor = Vec2::Zero();  // pixels
  double scale = 1;            // pixels per unit, > 0

  Vec2 to_screen(const Vec2& world) const;
  Vec2 to_world(const Vec2& screen) const;
};

// All points are within `room`, as large as possible. O(n).
Camera fit(const Points& points, const Rect& room);

// The point under `about` (pixels) stays in place. `smallest` and `largest` bound the scale.
Camera zoom(const Camera& camera, const Vec2& about, double factor, double smallest,
            double largest);

Camera pan(const Camera& camera, const Vec2& pixels);

// Between the dots: 1, 2 or 5 times a power of ten, at least 22 CSS pixels.
double grid_step(const Camera& camera);

// The dot nearest to `world`.
Vec2 nearest_dot(const Camera& camera, const Vec2& world);

// The nearest coordinates with no more decimals than a pixel needs: readable, and short in links.
Vec2 rounded_to_pixels(const Camera& camera, const Vec2& world);

// With two more decimals, so that turned or scaled shapes keep their form.
Vec2 rounded_finely(const Camera& camera, const Vec2& world);

}  // namespace evenlift::view
