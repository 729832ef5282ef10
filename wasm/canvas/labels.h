// Where numbers stand in the drawing: a load beside its robot, coverage inside H.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placement.h"
#include "state/camera.h"

namespace evenlift::view {

// A box in CSS pixels, or nothing where there is no room.
struct LabelRequest {
  Vec2 robot;    // CSS pixels
  Vec2 outward;  // unit, where there is likely to be room
  Vec2 size;     // of the text with its padding
};

// One place for each request, beside its robot and clear of the other robots and labels, as far as
// that goes, within `window` and not under `covered`. `reach` is the radius that a robot's mark
// takes. O(n²) for n requests.
std::vector<std::optional<Rect>> place_labels(const std::vector<LabelRequest>& requests,
                                              const Rect& window, const Rect& covered,
                                              double reach);

// The point inside both P and H farthest from chords, robots and outlines, and how far it is from
// them, in polygon coordinates; `before` stands while it is nearly as good, so that the number does
// not jump about. Room 0 where there is none.
struct CoveragePlace {
  Vec2 at = Vec2::Zero();
  double room = 0;
};
CoveragePlace place_coverage(const Placement& placement, const Vec2& before);

}  // namespace evenlift::view
