// A placement as an SVG picture for reports, without scripts or fonts to load.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/placement.h"

namespace evenlift {

// The polygon, H, chords, robots with their loads, the centre of mass and the two regions of free
// rotation centres (hatched, so that they differ without colour), fitted with a margin; a caption
// and a <title>/<desc> in words. The bytes are the same on every platform. Given the `link` of its
// document (link.h), evenlift can open the picture as that document. O(output).
std::string placement_svg(const ShownPlacement& of, std::string_view link = {});

// At half the size, for pictures side by side: letters and robots keep their size, and there is no
// caption or link. O(output).
std::string placement_sketch(const ShownPlacement& of);

}  // namespace evenlift
