// The lifting base H while teams are added to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// The corners of H in a counter-clockwise ring around C, which is the origin. A corner keeps its
// number as long as it is one.
class GrowingBase {
 public:
  using Corner = std::uint32_t;

  // `flat` as for convex_hull().
  explicit GrowingBase(double flat) : flat_(flat) {}

  std::size_t size() const { return size_; }
  bool has(Corner corner) const { return corners_[corner].in_ring; }
  const Vec2& position(Corner corner) const { return corners_[corner].position; }
  Corner next(Corner corner) const { return corners_[corner].next; }

  // Whether p is within the distance of an edge. O(h).
  bool is_near(const Vec2& p, double distance) const;

  // From the lowest of the leftmost corners, as by convex_hull(). O(h).
  Points positions() const;

  // A point to add, and the corner at which the edge begins through which C sees it.
  struct Added {
    Vec2 position;
    std::optional<Corner> edge;
  };

  // Adds both points and returns the corners at which a new edge begins, in the order of
  // positions(); none if H stays the same. O(changes) if only a few edges change and the hull has
  // many corners, otherwise O(h).
  std::vector<Corner> add(const Added& p, const Added& q);

 private:
  struct Node {
    Vec2 position;
    Corner next = 0, previous = 0;
    bool in_ring = true;
  };
  // Where a point belongs: in place of the corners between two others, or within H.
  struct Gap {
    bool inside = false;
    Corner before = 0, after = 0;
  };
  // How a point was put in, so that it can be taken out again as long as it is the last.
  struct Put {
    Gap gap;
    Corner next, previous;  // those of the corners beside the gap, before
    Corner first;
    std::size_t size;
  };
  double side(Corner edge, const Vec2& p) const;
  bool is_straight(const Vec2& before, Corner corner, const Vec2& after) const;
  std::optional<Gap> gap_for(const Added& added) const;
  std::optional<Gap> widest_gap(Corner visible, const Vec2& p) const;
  std::optional<std::vector<Corner>> add_locally(const Added& p, const Added& q);
  Put put(const Vec2& p, const Gap& gap);
  void take_out(const Put& put);
  std::vector<Corner> replace(const Points& positions);
  void link(Corner from, Corner to);

  double flat_;
  std::vector<Node> corners_;  // also past ones
  Corner first_ = 0;           // the lowest of the leftmost
  std::size_t size_ = 0;
};

}  // namespace evenlift
