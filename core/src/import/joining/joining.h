// Joins separate lines, arcs and curves into closed outlines: the faces of the planar graph that
// they form. Their order does not matter.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curves/outline.h"

namespace evenlift {

// A line, an arc, or an open polyline or path.
struct DrawnPiece {
  Outline outline;
  std::string layer;
  bool filled = false;  // if it is closed by itself
};

struct JoinedOutline {
  Outline outline;     // counter-clockwise, from its least point by x, then y
  std::size_t parts;   // its number of pieces
  std::string layer;   // of its pieces, the first by name
  bool across_layers;  // its pieces are on several layers
};

struct Joining {
  std::vector<JoinedOutline> outlines;
  std::vector<std::size_t> open;   // the pieces in no outline, in order
  std::vector<std::size_t> alone;  // those that meet no other piece
  // The greatest area of the box around open pieces that meet end to end. A straight line alone,
  // such as a centre line, has none.
  double greatest_open = 0;
  std::size_t repeated = 0;  // dropped parts of pieces that lie on another
  double gap = 0;            // the greatest distance of two ends that became one
  bool gap_is_seen = false;  // it exceeds rounding: beyond safe_reach of the larger side
  std::optional<std::pair<Vec2, Vec2>>
      apart;  // two ends that stayed open, the nearest to each other
};

// Open ends are joined within these parts of the drawing's larger side, and within a coarser one
// only where something stays open.
inline constexpr double safe_reach = 1e-5;  // beyond it an open end joins only another open end
inline constexpr double join_reaches[] = {1e-6, 1e-5, 1e-4, 1e-3};

// Joins pieces of the same layer, then all that are still open.
//
// Ends at the same place become one point, as do open ends that are near: first within the finest
// distance, then within coarser ones, up to `reach` if given. A straight line joins ends beyond the
// coarsest usual distance. An end on the middle of a straight line divides it. What lies on another
// piece is dropped, as is all that leads nowhere: ends that stay open, and lines between two
// outlines. Each remaining face is an outline, but not the boundary around faces that share a line.
// O(n log n) for n ends, but O(n sqrt(n) log n) if most lines are as long as the drawing.
Joining join(const std::vector<DrawnPiece>& pieces, std::optional<double> reach = std::nullopt);

}  // namespace evenlift
