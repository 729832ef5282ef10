// One shape, one answer (algorithm.md): a shape turned, mirrored, moved and scaled by any amount,
// in plain doubles, has the same placement. This checks it for one shape and one motion; the unit
// tests and the soak bring the shapes.
#pragma once

#include <string>

#include "evenlift/document.h"
#include "evenlift/random.h"

namespace one_shape {

// First mirrored at the y axis, then turned, scaled and moved. Each step rounds.
struct Motion {
  bool mirrored = false;
  double angle_rad = 0;
  double scale = 1;
  evenlift::Vec2 shift = evenlift::Vec2::Zero();
};

// Any angle, either way round, by a factor that is no power of two, to somewhere near. The
// document's vertices must be a valid polygon.
Motion any_motion(const evenlift::Document& document, evenlift::Rng& rng);

// The document moved so. A centre of mass that is given moves with it.
evenlift::Document moved(const evenlift::Document& document, const Motion& motion);

// Numbers that must stay agree within this: ratios, shares and margins absolutely, loads in units
// of the weight.
inline constexpr double allowed = 1e-7;

struct Comparison {
  std::string differences;  // one a line; empty if there are none
  // How often a choice of the copy was another one, which ties with the original's in every key but
  // candidate order. The copy then goes on with the original's choice.
  int ties = 0;
};

// Compares the candidates, and for 1 to `teams` teams the coverage, loads, verdicts and margin, of
// the document's placement by its method (area, circle or distance) with those of its copy.
Comparison compare(const evenlift::Document& document, const Motion& motion, std::uint32_t teams);

// Whether the question has an answer: the centre of mass is farther from the rim of the convex hull
// than rounding can move it, since what is refused at the door is decided exactly.
bool is_clear_of_refusal(const evenlift::Document& document);

// The document and motion as text, for messages.
std::string text(const evenlift::Document& document, const Motion& motion);

}  // namespace one_shape
