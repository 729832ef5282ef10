// Finds places for numbers in the picture. Every frame of a drag needs these places, so this code
// works with cells of pixels. For pictures in files, there is time for exact measurements
// (evenlift/output/label_places.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/report.h"
#include "state/camera.h"

namespace evenlift::view {

struct LabelRequest {
  Vec2 robot;        // in pixels
  Vec2 outward;      // unit vector in a direction that probably has free space
  Vec2 size;         // of the text with its padding, in pixels
  double reach = 0;  // radius to keep clear, in pixels, if it is larger than a robot's mark
};

// The occupied cells of the canvas. Each cell is a few pixels wide, so a query for a box costs the
// same with a thousand lines as with one. Labels must not cover boxes, and should not cover lines.
class Occupied {
 public:
  explicit Occupied(const Rect& window);
  void box(const Rect& taken);
  void disc(const Vec2& middle, double radius);
  void line(const Vec2& a, const Vec2& b);
  bool is_free(const Rect& wanted) const;  // whether it is in the window and clear of boxes
  int crossed(const Rect& wanted) const;   // number of cells with a line

 private:
  struct Cells {
    int left, top, right, bottom;  // right and bottom are exclusive
  };
  Cells cells(const Rect& area) const;
  std::size_t index_of(int x, int y) const;
  Rect window_;
  int across_, down_;
  std::vector<std::uint8_t> boxes_, lines_;
};

// Returns a box in pixels for each request. The box is beside the request's robot; it covers no
// occupied box, and as few lines as possible. The result is nullopt if no place is free, or if
// every free place would cover lines in more than `most_crossed` cells. `reach` is the radius of a
// robot's mark. The boxes are added to `occupied`. O(n) for n requests of bounded size.
std::vector<std::optional<Rect>> place_labels(const std::vector<LabelRequest>& requests,
                                              Occupied& occupied, double reach, int most_crossed);

// The place of the coverage's number, in polygon coordinates. It is the point of a grid, inside the
// object and the lifting base, that is farthest from the outlines of both and from chords, robots,
// the centre of mass and cargo; `room` is its distance from the nearest of these. The former place
// `before` is kept unless another point has more than 1.3 times the room, so that the number does
// not jump. If there is no such point, or there are too many vertices, teams or items of cargo to
// search, `room` is 0.
struct CoveragePlace {
  Vec2 at;
  double room = 0;
};
CoveragePlace place_coverage(const Placement& placement, const Vec2& before);

}  // namespace evenlift::view
