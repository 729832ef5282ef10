// Where numbers are written in the drawing: a load beside its robot, the coverage inside the
// lifting base. This runs in every frame of a drag, so it tries few places; pictures in files take
// the time to keep clear of edges and chords, too (core/src/output/svg/label_places.h).
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placement.h"
#include "state/camera.h"

namespace evenlift::view {

// A label that wants a place.
struct LabelRequest {
  Vec2 robot;    // CSS pixels
  Vec2 outward;  // unit vector towards where there is likely to be room
  Vec2 size;     // of the text with its padding
};

// A box in CSS pixels for each request, or nothing where there is no room: beside its robot, clear
// of the other robots and labels, within `window` and clear of `covered`. `reach` is the radius of
// a robot's mark. O(n²) for n requests.
std::vector<std::optional<Rect>> place_labels(const std::vector<LabelRequest>& requests,
                                              const Rect& window, const Rect& covered,
                                              double reach);

// The point inside both the polygon and the lifting base that is farthest from chords, robots and
// outlines, and its distance to them, in polygon coordinates. While `before` is nearly as good it
// is kept, so that the number does not jump. The room is 0 if there is no such point.
struct CoveragePlace {
  Vec2 at = Vec2::Zero();
  double room = 0;
};
CoveragePlace place_coverage(const Placement& placement, const Vec2& before);

}  // namespace evenlift::view
