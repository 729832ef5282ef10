// The corners at which the straight runs of an outline end. Vertices that do not turn join edges to one run,
// so that a vertex more on a side changes nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/polygon.h"

namespace evenlift {

class Corners {
 public:
  // O(n).
  explicit Corners(const Polygon& polygon);

  // The corner (Polygon::is_corner) at which the run of an edge begins or ends, in the order of the
  // vertices; none if a reflex vertex or a slight turn is there. O(1).
  std::optional<std::uint32_t> before(std::uint32_t edge) const { return some(before_[edge]); }
  std::optional<std::uint32_t> after(std::uint32_t edge) const { return some(after_[edge]); }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static std::optional<std::uint32_t> some(std::uint32_t corner) {
    return corner == none ? std::nullopt : std::optional(corner);
  }

  std::vector<std::uint32_t> before_, after_;  // by edge
};

}  // namespace evenlift
