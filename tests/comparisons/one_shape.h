// One shape, one answer (algorithm.md): a shape turned, mirrored, moved and scaled by any amount,
// in plain doubles, has the same placement. This checks it for one shape and one motion; the unit
// tests and the soak test supply the shapes.
#pragma once

#include <string>

#include "evenlift/document.h"
#include "evenlift/random.h"

namespace one_shape {

// Mirrored at the y axis first, then turned, scaled and moved. Each step rounds.
struct Motion {
  bool mirrored = false;
  double angle_rad = 0;
  double scale = 1;
  evenlift::Vec2 shift = evenlift::Vec2::Zero();
};

// Any angle, either orientation, a factor that is not a power of two, and a short shift. The
// document's vertices must be a valid polygon.
Motion any_motion(const evenlift::Document& document, evenlift::Rng& rng);

// The document after this motion. A given centre of mass moves with it.
evenlift::Document moved(const evenlift::Document& document, const Motion& motion);

// Numbers that must not change agree within this: ratios, shares and margins absolutely, loads in
// units of the weight.
inline constexpr double allowed = 1e-7;

struct Comparison {
  std::string differences;  // one a line; empty if there are none
  // The number of different choices of the copy that tie with the original's in every key but
  // candidate order. The copy then continues with the original's choice.
  int ties = 0;
};

// Compares the placement of the document by its method (area, circle or distance) with its copy's:
// the candidates, and for 1 to `teams` teams the coverage, loads, verdicts and margin.
Comparison compare(const evenlift::Document& document, const Motion& motion, std::uint32_t teams);

// Whether a comparison is meaningful: the centre of mass is farther from the boundary of the convex
// hull than rounding can move it, because refusals are decided exactly.
bool is_clear_of_refusal(const evenlift::Document& document);

// The document and motion as text, for messages.
std::string text(const evenlift::Document& document, const Motion& motion);

}  // namespace one_shape
