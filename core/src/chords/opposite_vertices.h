// The vertices that are opposite each other across C (algorithm.md, Opposite vertices).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "chords/radial_view.h"
#include "evenlift/chords.h"

namespace evenlift {

// Like opposite_vertices(), but nothing if there are more than `most`. O(n) instead of O(n log n),
// since the view has sorted the vertices.
std::optional<std::vector<OppositeVertices>> find_opposite_vertices(const Polygon& polygon,
                                                                    const Vec2& centre,
                                                                    const RadialView& view,
                                                                    std::uint64_t most);

// `v` and `w` are offsets from C; `near` is tau L. O(1).
bool are_opposite(const Vec2& v, const Vec2& w, double near);

// The error for too many edge pairs and opposite vertices.
InputError too_many_opposite_vertices();

}  // namespace evenlift
