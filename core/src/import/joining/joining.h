// Joins separate lines, arcs and curves into closed outlines: the bounded faces of the planar graph
// that the pieces form. The order of the pieces does not matter.
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
  bool filled = false;  // matters if a straight edge closes the piece
};

struct JoinedOutline {
  Outline outline;     // counter-clockwise, from the corner that is first by x, then y
  std::size_t parts;   // the number of its pieces
  std::string layer;   // the first, by name, of the layers of its pieces
  bool across_layers;  // its pieces are on several layers
};

struct Joining {
  std::vector<JoinedOutline> outlines;
  std::vector<std::size_t> open;   // the pieces in no outline, in order
  std::vector<std::size_t> alone;  // those of `open` whose ends meet no other piece's ends
  // The greatest area of a box around open pieces that meet end to end. A straight line alone, such
  // as a centre line, does not count.
  double greatest_open = 0;
  std::size_t repeated = 0;  // number of dropped parts that lie on another piece
  double gap = 0;            // the greatest distance of two ends that were joined
  bool gap_is_seen = false;  // the gap exceeds 1.5 safe_reach times the larger side
  // The two nearest of the ends that stayed open, if there are 2 to 1000 of them.
  std::optional<std::pair<Vec2, Vec2>> apart;
};

// Open ends are joined within these shares of the drawing's larger side. Shares coarser than
// safe_reach are used only where ends are still open.
inline constexpr double safe_reach = 1e-5;  // beyond it, an open end joins only another open end
inline constexpr double join_reaches[] = {1e-6, 1e-5, 1e-4, 1e-3};

// Joins pieces of the same layer, then all pieces that are still open.
//
// Ends at the same place become one point. An open end also joins the ends near it: first within
// the finest of join_reaches, then within the coarser ones. If the distance `reach` is given, only
// those below `reach` are used, and then `reach` itself. A straight line joins open ends that are
// farther apart than the coarsest of join_reaches, if `reach` allows. An end in the interior of a
// straight line divides this line. Parts that lie on another piece are dropped. So are parts that
// lead nowhere: those with an open end, and lines between two outlines. Each remaining bounded face
// is an outline. The boundary around several faces that share lines is not an outline. O(n log n)
// for n ends, but O(n sqrt(n) log n) if most lines are as long as the drawing.
Joining join(const std::vector<DrawnPiece>& pieces, std::optional<double> reach = std::nullopt);

}  // namespace evenlift
