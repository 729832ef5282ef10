// One edge, and what it loses to which reason.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/stands.h"

namespace evenlift {

// All of WhyUnusable but `narrow`, which is the last.
inline constexpr std::size_t reasons_to_lose = static_cast<std::size_t>(WhyUnusable::narrow);

class Losses {
 public:
  // Takes an open stretch away, which may reach beyond the edge. O(1).
  void add(WhyUnusable why, const Stretch& lost) {
    lost_[static_cast<std::size_t>(why)].push_back(lost);
  }

  // The parts of an edge of this length, from its beginning to its end: with the first reason for
  // which they are lost, or without one. Neighbours differ in that. O(k log k) for k stretches.
  struct Part {
    Stretch part;
    std::optional<WhyUnusable> why;
  };
  std::vector<Part> parts(double length);

 private:
  std::array<std::vector<Stretch>, reasons_to_lose> lost_;
};

}  // namespace evenlift
