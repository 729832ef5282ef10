// Finds a free place for each label of a picture, beside the thing that the label names, and
// outside the object if there is space. Coordinates are in pixels, or in a unit of about that size.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "evenlift/plane.h"

namespace evenlift::labels {

using evenlift::Box;

using Segment = std::pair<Vec2, Vec2>;

struct Request {
  Box owner;  // the box around the thing that the label names
  Vec2 away;  // the preferred direction from the owner, as a vector of any length
  Vec2 size;  // of the label
};

struct Surroundings {
  Box frame;                       // labels stay inside
  Points outline;                  // labels avoid its inside, and its edges even more
  std::vector<Segment> chords;     // avoided if possible
  std::vector<Box> marks;          // never covered; may include owners
  std::vector<Points> holes = {};  // of the object; labels may be inside, but avoid the edges
};

// Returns a box for each label, or nothing for a label if every place would leave the frame or
// cover a mark, an owner or another label. For each label it tries 24 directions and three
// distances and takes the place with the least cost, which counts distance, direction and overlaps.
// Then it places each label again among all others. O(labels (n + labels + chords + marks)).
std::vector<std::optional<Box>> place(const std::vector<Request>& requests,
                                      const Surroundings& around);

}  // namespace evenlift::labels
