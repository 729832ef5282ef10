// Joins separate lines, arcs and curves into closed outlines, which are the faces of the planar
// graph that the lines and curves form. Their order does not matter.
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
  bool filled = false;  // matters if the piece is closed by itself
};

struct JoinedOutline {
  Outline outline;     // counter-clockwise, from its least point by x, then y
  std::size_t parts;   // the number of its pieces
  std::string layer;   // the first by name of its pieces' layers
  bool across_layers;  // its pieces are on several layers
};

struct Joining {
  std::vector<JoinedOutline> outlines;
  std::vector<std::size_t> open;   // the pieces in no outline, in order
  std::vector<std::size_t> alone;  // those that meet no other piece
  // The greatest area of a box around open pieces that meet end to end. A straight line alone, such
  // as a centre line, does not count.
  double greatest_open = 0;
  std::size_t repeated = 0;  // dropped parts of pieces that lie on another
  double gap = 0;            // the greatest distance of two ends that became one
  bool gap_is_seen = false;  // the gap exceeds rounding: safe_reach times the larger side
  std::optional<std::pair<Vec2, Vec2>>
      apart;  // the two ends nearest to each other of those that stayed open
};

// Open ends are joined within these shares of the drawing's larger side. A coarser share is used
// only where ends stay open.
inline constexpr double safe_reach = 1e-5;  // beyond it an open end joins only another open end
inline constexpr double join_reaches[] = {1e-6, 1e-5, 1e-4, 1e-3};

// Joins pieces of the same layer, then all pieces that are still open.
//
// Ends at the same place become one point, as do open ends that are near: first within the finest
// distance, then within coarser ones, up to `reach` if given. A straight line joins ends beyond the
// coarsest usual distance. An end on the middle of a straight line divides this line. Parts that
// lie on another piece are dropped. So are parts that lead nowhere: those with an open end, and
// lines between two outlines. Each remaining face is an outline. The boundary around faces that
// share a line is not. O(n log n) for n ends, but O(n sqrt(n) log n) if most lines are as long as
// the drawing.
Joining join(const std::vector<DrawnPiece>& pieces, std::optional<double> reach = std::nullopt);

}  // namespace evenlift
