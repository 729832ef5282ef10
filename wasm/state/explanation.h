// A part of the drawing, and the answer to "why here?" about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::view {

// A part of the drawing that is under the pointer or held.
struct Pick {
  enum class Kind : std::uint8_t {
    none,
    vertex,
    centre,
    robot,
    chord,
    candidate,
    edge,
    object,
    frame,
    ground,
    uncertainty,  // the grip of the ring for the C uncertainty
    cargo         // a weight on the object
  };
  Kind kind = Kind::none;
  std::size_t index = 0;  // of the vertex, edge, team, candidate, weight or frame's grip
  int end = 0;            // of a robot: its index in the team; r1 is 0, and r2 is 1
  Vec2 at;                // in polygon coordinates; on an edge or chord, nearest to the pointer
  bool second = false;    // the part is in the second method's picture
  bool operator==(const Pick&) const = default;
};

// The contents of the card about a robot, a team's chord or a candidate.
struct Explanation {
  struct Row {
    std::string label, value;
  };
  Pick of;
  std::optional<std::size_t> robot;  // the robot's number from 0, in the first picture
  std::string title;
  std::vector<Row> rows;
  std::string reason;
  std::optional<std::uint32_t> step;  // the walkthrough's step that decides on this part
};

}  // namespace evenlift::view
