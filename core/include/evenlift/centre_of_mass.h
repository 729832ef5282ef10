// The centre of mass of the object, alone and with its cargo.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/result.h"

namespace evenlift {

struct CentreOfMass {
  Vec2 own;  // C0, of the object alone
  Vec2 all;  // C, with its cargo
};

// C for the object whose C0 is `own`. O(items).
Vec2 with_cargo(const Vec2& own, const Settings& settings);

// Finds C0 and C. C0 is the given point, or else the centroid of the area that the holes leave.
// With the object's weight W0 and cargo of weights w at q, C = (W0 C0 + sum w q) / (W0 + sum w). It
// is an error if C is not strictly inside the convex hull of the outline (an exact test). A
// coordinate of a given C0 is an error if it is not finite, or if its absolute value exceeds
// max_coordinate or is above 0 but below min_coordinate. Apart from that, C0 and cargo may lie
// anywhere. O(items + h) for h corners of the hull.
Result<CentreOfMass> centre_of_mass(const PolygonWithHoles& object,
                                    const std::optional<Vec2>& given, const Settings& settings);

// The weight and C with only the first `items` items of cargo. Without items they are W0 and `own`;
// with all items they are the whole weight and C, bit for bit. O(items).
struct Loaded {
  double weight = 0;
  Vec2 centre;
};
Loaded with_cargo(const Vec2& own, const Settings& settings, std::size_t items);

}  // namespace evenlift
