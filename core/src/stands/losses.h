// The ranges of an edge that are lost, since no robot can use them, and the reasons.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/stands.h"

namespace evenlift {

// The number of values of WhyUnusable without the last, `narrow`.
inline constexpr std::size_t reasons_to_lose = static_cast<std::size_t>(WhyUnusable::narrow);

class Losses {
 public:
  // Adds an open range that is lost for this reason. It may reach beyond the edge. O(1).
  void add(WhyUnusable why, const Stretch& lost) {
    lost_[static_cast<std::size_t>(why)].push_back(lost);
  }

  // The parts of an edge of this length, in order. `why` is the first of the part's reasons in the
  // order of WhyUnusable, or nullopt if the part is usable; neighbouring parts have different
  // values. O(k log k) for k ranges.
  struct Part {
    Stretch part;
    std::optional<WhyUnusable> why;
  };
  std::vector<Part> parts(double length);

 private:
  std::array<std::vector<Stretch>, reasons_to_lose> lost_;
};

}  // namespace evenlift
