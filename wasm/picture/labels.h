// Places for numbers in the drawing. They are needed in every frame of a drag, so this works with
// cells of pixels; pictures in files can afford exact measurements
// (evenlift/output/label_places.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/placement.h"
#include "state/camera.h"

namespace evenlift::view {

struct LabelRequest {
  Vec2 robot;        // pixels
  Vec2 outward;      // unit vector that probably leads to room
  Vec2 size;         // of the text with its padding
  double reach = 0;  // radius to keep clear, if larger than a robot's mark
};

// The occupied cells of the canvas, a few pixels large: a query for a box costs the same with a
// thousand lines as with one. Labels must not cover boxes, and should not cover lines.
class Occupied {
 public:
  explicit Occupied(const Rect& window);
  void box(const Rect& taken);
  void disc(const Vec2& middle, double radius);
  void line(const Vec2& a, const Vec2& b);
  bool is_free(const Rect& wanted) const;  // inside the window, and clear of boxes
  int crossed(const Rect& wanted) const;   // number of cells with a line

 private:
  struct Cells {
    int left, top, right, bottom;  // the ends are exclusive
  };
  Cells cells(const Rect& area) const;
  std::size_t index_of(int x, int y) const;  // of a cell
  Rect window_;
  int across_, down_;
  std::vector<std::uint8_t> boxes_, lines_;
};

// A box in pixels for each request, beside its robot, clear of boxes, and of lines as far as
// possible; nothing without room, or if it would cover lines in more than `most_crossed` cells.
// `reach` is the radius of a robot's mark. The boxes are added to `occupied`. O(n) for n requests,
// apart from their sizes.
std::vector<std::optional<Rect>> place_labels(const std::vector<LabelRequest>& requests,
                                              Occupied& occupied, double reach, int most_crossed);

// The point inside the object and the lifting base that is farthest from chords, robots, cargo and
// outlines, and its distance to them, in polygon coordinates. `before` is kept while it is nearly
// as good, so that the number does not jump. Without such a point the room is 0.
struct CoveragePlace {
  Vec2 at = Vec2::Zero();
  double room = 0;
};
CoveragePlace place_coverage(const Placement& placement, const Vec2& before);

}  // namespace evenlift::view
