// Converts polygon coordinates to canvas pixels (y down) and back.
#pragma once

#include <optional>

#include "evenlift/vec.h"

namespace evenlift::view {

// A rectangle in pixels; the origin is the canvas's top left corner.
struct Rect {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Vec2 middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
  bool operator==(const Rect&) const = default;
  bool contains(const Vec2& p) const {
    return p.x >= left && p.x < right && p.y >= top && p.y < bottom;
  }
  bool overlaps(const Rect& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

// The part of a segment from a to b, as fractions of the way from a. part_within() returns the part
// in a rectangle (boundary included), or nullopt if segment and rectangle do not meet. O(1).
struct PartOfSegment {
  double from = 0, to = 1;
};
std::optional<PartOfSegment> part_within(const Rect& rect, const Vec2& a, const Vec2& b);

struct Camera {
  Vec2 centre;       // polygon coordinates at `anchor`
  Vec2 anchor;       // pixels
  double scale = 1;  // pixels per unit, > 0

  Vec2 to_screen(const Vec2& world) const;
  Vec2 to_world(const Vec2& screen) const;
};

// Returns the camera that shows all points within `room`, as large as possible. O(n).
Camera fit(const Points& points, const Rect& room);

// Returns the camera with its scale multiplied by `factor`, but limited to the range from
// `smallest` to `largest`. The point under `about` (pixels) stays in place.
Camera zoom(const Camera& camera, const Vec2& about, double factor, double smallest,
            double largest);

// Returns the camera after the drawing moved by this many pixels.
Camera pan(const Camera& camera, const Vec2& pixels);

// Returns the distance between the dots of the grid, in polygon coordinates: the least number that
// is 1, 2 or 5 times a power of ten and at least 22 pixels on the screen.
double grid_step(const Camera& camera);

Vec2 nearest_dot(const Camera& camera, const Vec2& world);

// Returns the nearest coordinates with no more decimals than a pixel needs. Such coordinates are
// readable, and short in links.
Vec2 rounded_to_pixels(const Camera& camera, const Vec2& world);

// Rounds to two more decimals than rounded_to_pixels(), so that turned or scaled shapes keep their
// form.
Vec2 rounded_finely(const Camera& camera, const Vec2& world);

}  // namespace evenlift::view
