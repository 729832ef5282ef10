#pragma once

#include "evenlift/polygon_with_holes.h"

namespace evenlift {

inline PolygonWithHoles solid(const Polygon& polygon) { return PolygonWithHoles(polygon); }

}  // namespace evenlift
