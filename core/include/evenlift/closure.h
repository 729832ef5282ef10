// Whether the robots also immobilize the object (algorithm.md, Immobilization; thesis 5.5).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/chords.h"

namespace evenlift {

// A frictionless contact of a robot with an edge.
struct Contact {
  Vec2 position = Vec2::Zero();
  std::uint32_t edge = 0;
  std::uint32_t point = 0;  // index of the lifting point it belongs to
};

// The direction in which an edge's contact pushes, of unit length. O(1).
Vec2 inward_normal(const Polygon& polygon, std::uint32_t edge);

// The contacts of lifting points: at a point inside an edge one, at a reflex vertex two, at a
// straight vertex one, at a convex vertex none. "At a vertex" is within tau L of it.
// O(m log n + n log n).
std::vector<Contact> contacts(const Polygon& polygon, const std::vector<LiftingPoint>& points);

// Centres of free rotation of one sense: a convex region, perhaps unbounded or far away.
struct FreeRegion {
  bool exists = false;    // some centre is free, wherever it lies
  bool has_area = false;  // wider than the tolerance alone makes it
  Points clipped;         // the region within the square about C with half side 100 L,
                          // counter-clockwise; empty, one or two points where it has no area there
};

// The regions of free rotation centres that contacts leave. O(m log m) for m contacts on e edges;
// O(e^2) where a region has no area.
struct FreeRegions {
  FreeRegion clockwise, counterclockwise;
};
FreeRegions free_regions(const Polygon& polygon, const Vec2& centre,
                         const std::vector<Contact>& contacts);

struct Closure {
  bool form_closure = false;     // nothing is free to first order
  std::optional<double> margin;  // of the wrenches, none without contacts; > 0 in form closure
  bool second_order = false;     // immobile although first-order motions are free
  bool translation_free = true;
  std::optional<Vec2> translation;  // a free direction, unit length, if any
  FreeRegion clockwise, counterclockwise;
};

// analyse_closure's form_closure alone, which more points never end. O(m log m + n log n).
bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<LiftingPoint>& points);

// The thesis's own test (5.5): that neither region of free rotation centres has an area. It takes
// an object for held that can slide between parallel sides, or still turns about a single point.
// O(m log m + n log n).
bool no_region_has_area(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

// Analyses the grasp of robots at `points`. Emptiness of the regions and free translations are
// decided exactly from the edges' directions and the rounded points. O(m log m) for m contacts
// on e edges, of which only the first and the last on each edge count; O(e^2) for the margin, and
// where a free region has no area.
Closure analyse_closure(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

}  // namespace evenlift
