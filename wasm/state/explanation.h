// The answer to "why here?" about a robot, a team's chord or a candidate that somebody pressed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::view {

struct Explanation {
  struct Row {
    std::string label, value;
  };
  Vec2 at = Vec2::Zero();            // what it is about, in polygon coordinates
  bool second = false;               // whether it is in the picture of the second method
  std::optional<std::size_t> robot;  // that it is about, in the first picture: its number from 0
  std::string title;
  std::vector<Row> rows;
  std::string reason;
  std::optional<std::uint32_t> step;  // of the walkthrough, where this is decided
};

}  // namespace evenlift::view
