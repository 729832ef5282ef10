// One edge, and the ranges that it loses, with the reasons.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/stands.h"

namespace evenlift {

// All of WhyUnusable except `narrow`, the last one.
inline constexpr std::size_t reasons_to_lose = static_cast<std::size_t>(WhyUnusable::narrow);

class Losses {
 public:
  // Removes an open range, which may reach beyond the edge. O(1).
  void add(WhyUnusable why, const Stretch& lost) {
    lost_[static_cast<std::size_t>(why)].push_back(lost);
  }

  // The parts of an edge of this length, from its beginning to its end, each with the first reason
  // for its loss, or without a reason. Neighbours differ in the reason. O(k log k) for k ranges.
  struct Part {
    Stretch part;
    std::optional<WhyUnusable> why;
  };
  std::vector<Part> parts(double length);

 private:
  std::array<std::vector<Stretch>, reasons_to_lose> lost_;
};

}  // namespace evenlift
