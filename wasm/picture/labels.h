// Where numbers are written in the drawing: a load beside its robot, the coverage inside the
// lifting base. This runs in every frame of a drag, so it looks at cells of pixels; pictures in
// files take the time to measure (evenlift/output/label_places.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/placement.h"
#include "state/camera.h"

namespace evenlift::view {

// A label that wants a place.
struct LabelRequest {
  Vec2 robot;        // pixels
  Vec2 outward;      // unit vector towards where there is likely to be room
  Vec2 size;         // of the text with its padding
  double reach = 0;  // of what stands there, if it is larger than a robot's mark
};

// What is already on the canvas, in cells of a few pixels: asking for the room of a box costs no
// more with a thousand lines than with one. Boxes must not be covered; lines are better not.
class Occupied {
 public:
  explicit Occupied(const Rect& window);
  void box(const Rect& taken);
  void disc(const Vec2& middle, double radius);
  void line(const Vec2& a, const Vec2& b);
  bool is_free(const Rect& wanted) const;  // inside the window, and clear of boxes
  int crossed(const Rect& wanted) const;   // cells with a line in it

 private:
  struct Cells {
    int left, top, right, bottom;  // the last ones are beyond
  };
  Cells cells(const Rect& area) const;
  std::size_t index_of(int x, int y) const;  // of a cell
  Rect window_;
  int across_, down_;
  std::vector<std::uint8_t> boxes_, lines_;
};

// A box in pixels for each request, or nothing where there is no room: beside its robot, clear of
// boxes, and of lines as far as that is possible; a box that would cover lines in more than
// `most_crossed` cells is left out. `reach` is the radius of a robot's mark. The boxes are entered
// as taken. O(n) for n requests, besides their size.
std::vector<std::optional<Rect>> place_labels(const std::vector<LabelRequest>& requests,
                                              Occupied& occupied, double reach, int most_crossed);

// The point inside both the polygon and the lifting base that is farthest from chords, robots and
// outlines, and its distance to them, in polygon coordinates. While `before` is nearly as good it
// is kept, so that the number does not jump. The room is 0 if there is no such point.
struct CoveragePlace {
  Vec2 at = Vec2::Zero();
  double room = 0;
};
CoveragePlace place_coverage(const Placement& placement, const Vec2& before);

}  // namespace evenlift::view
