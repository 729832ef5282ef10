// Finds a free place for each of the words in a picture beside what they name, outside of the
// object where there is room. Places are pixels, or any other unit of about that size.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "evenlift/plane.h"

namespace evenlift::labels {

using evenlift::Box;

using Segment = std::pair<Vec2, Vec2>;

struct Request {
  Box owner;                 // what the label names
  Vec2 away = Vec2::Zero();  // the direction that is preferred, any length
  Vec2 size = Vec2::Zero();  // of the label
};

struct Surroundings {
  Box frame;                    // labels stay inside
  Points outline;               // of the object: its inside is avoided, its edges more
  std::vector<Segment> chords;  // avoided if possible
  std::vector<Box> marks;       // never covered; what a label names may be among them
};

// A box for each label in turn; nothing for a label if every place would cover a mark, an owner or
// another label. Tries all directions and a few distances, takes the cheapest place, and goes over
// all labels a second time when the others are known. O(labels (n + labels + chords)).
std::vector<std::optional<Box>> place(const std::vector<Request>& requests,
                                      const Surroundings& around);

}  // namespace evenlift::labels
