// One shape, one answer (algorithm.md): a shape turned, mirrored, moved and scaled by any amount,
// in plain doubles, has the same placement. The unit tests and the soak test supply shapes and
// motions.
#pragma once

#include <string>

#include "evenlift/document.h"
#include "evenlift/random.h"

namespace one_shape {

// Mirrored at the y axis, then turned, scaled and moved. Each step rounds.
struct Motion {
  bool mirrored = false;
  double angle_rad = 0;
  double scale = 1;
  evenlift::Vec2 shift;
};

// Any angle, either orientation, a factor that is not a power of two, and a short shift, for a
// valid polygon.
Motion any_motion(const evenlift::Document& document, evenlift::Rng& rng);

// A given centre of mass moves too.
evenlift::Document moved(const evenlift::Document& document, const Motion& motion);

// How far unchanged numbers may differ: ratios, shares and margins absolutely, loads in units of
// the weight.
inline constexpr double allowed = 1e-7;

struct Comparison {
  std::string differences;  // one a line
  // The number of the copy's choices that differ from the original's but tie in every key except
  // candidate order. The copy then continues with the original's.
  int ties = 0;
};

// Compares the placement by the document's method (area, circle or distance) with its copy's:
// candidates, and for 1 to `teams` teams coverage, loads, verdicts and margin.
Comparison compare(const evenlift::Document& document, const Motion& motion, std::uint32_t teams);

// Refusals are decided exactly, so C must be farther from the boundary of the convex hull than
// rounding can move it.
bool is_clear_of_refusal(const evenlift::Document& document);

// For messages.
std::string text(const evenlift::Document& document, const Motion& motion);

}  // namespace one_shape
