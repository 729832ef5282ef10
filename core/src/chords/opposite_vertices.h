// Finds the vertices that are opposite each other across C (algorithm.md, Opposite vertices).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "chords/radial_view.h"
#include "evenlift/chords.h"

namespace evenlift {

// Returns the result of opposite_vertices() (chords.h), or nothing if there are more than `most`
// pairs. The cost is that of opposite_vertices() with O(n) in place of O(n log n), since `view` has
// already sorted the vertices.
std::optional<std::vector<OppositeVertices>> find_opposite_vertices(const Polygon& polygon,
                                                                    const Vec2& centre,
                                                                    const RadialView& view,
                                                                    std::uint64_t most);

// Whether two vertices are opposite. `v` and `w` are their offsets from C; `near` is tau L. O(1).
bool are_opposite(const Vec2& v, const Vec2& w, double near);

// The error if there are too many edge pairs and opposite vertices together.
InputError too_many_opposite_vertices();

}  // namespace evenlift
