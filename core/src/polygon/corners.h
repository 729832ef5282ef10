// The convex vertices at the ends of an outline's straight runs, which of them are corners
// (Polygon::is_corner), and how far corners are along the outline. Straight vertices join their
// edges into one run, so extra vertices on a straight side change nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/polygon.h"

namespace evenlift {

class Corners {
 public:
  // The polygon must outlive this object. O(n).
  explicit Corners(const Polygon& polygon);

  // The vertex where the run of an edge begins or ends, in the order of the vertices; nullopt if
  // this vertex is reflex. O(1).
  std::optional<std::uint32_t> before(std::uint32_t edge) const { return some(before_[edge]); }
  std::optional<std::uint32_t> after(std::uint32_t edge) const { return some(after_[edge]); }

  // Whether the vertex is a corner (Polygon::is_corner). O(1).
  bool is_corner(std::uint32_t vertex) const { return is_corner_[vertex]; }

  // The distance along the outline from a point on an edge to the nearest corner, in either direction
  // and past vertices that turn little; infinite if there is none, or none before the next notch
  // (Polygon::is_notch). O(1).
  double distance_to(const Vec2& point, std::uint32_t edge) const;

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static std::optional<std::uint32_t> some(std::uint32_t vertex) {
    return vertex == none ? std::nullopt : std::optional(vertex);
  }

  const Polygon& polygon_;
  std::vector<std::uint32_t> before_, after_;  // by edge
  std::vector<bool> is_corner_;                // by vertex
  std::vector<std::uint32_t> begin_, end_;     // by edge: the ends of its run
  std::vector<double> back_,
      on_;  // from the end of a run to the nearest corner before and after it
};

}  // namespace evenlift
