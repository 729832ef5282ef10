// A placement as an SVG picture for reports. It is self-contained: no scripts, no fonts to load.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/placement.h"

namespace evenlift {

// Polygon, H, chords, robots with their loads, centre of mass and the two closure regions (hatched,
// so that they are told apart without colour), fitted with a margin; a caption and a <title>/<desc>
// in words. The same bytes on every platform. With the `link` of its document (link.h), the
// picture opens again as that document. O(output).
std::string placement_svg(const ShownPlacement& of, std::string_view link = {});

// The same picture half as large, with letters and robots of the same size, and without the caption
// and the link: for pictures beside each other. O(output).
std::string placement_sketch(const ShownPlacement& of);

}  // namespace evenlift
