// The ranges that an edge loses, and why.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/stands.h"

namespace evenlift {

// All of WhyUnusable but the last, `narrow`.
inline constexpr std::size_t reasons_to_lose = static_cast<std::size_t>(WhyUnusable::narrow);

class Losses {
 public:
  // An open range, which may reach beyond the edge. O(1).
  void add(WhyUnusable why, const Stretch& lost) {
    lost_[static_cast<std::size_t>(why)].push_back(lost);
  }

  // The parts of an edge of this length, in order, each with the first reason for its loss, or
  // none. Neighbours differ. O(k log k) for k ranges.
  struct Part {
    Stretch part;
    std::optional<WhyUnusable> why;
  };
  std::vector<Part> parts(double length);

 private:
  std::array<std::vector<Stretch>, reasons_to_lose> lost_;
};

}  // namespace evenlift
