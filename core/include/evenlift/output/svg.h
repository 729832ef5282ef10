// Draws a placement as an SVG picture for reports, without scripts or fonts to load.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/placement.h"

namespace evenlift {

// Draws the polygon, H, chords, robots with their loads, the centre of mass and the two regions of
// free rotation centres (hatched, so that they differ without colour), fitted with a margin. A
// caption and a <title>/<desc> describe them in words. The bytes are the same on every platform. If
// `link` is the link of the document (link.h), evenlift can open the picture as that document.
// O(output).
std::string placement_svg(const ShownPlacement& of, std::string_view link = {});

// Draws the same at half the size, for pictures side by side. Letters and robots keep their size,
// and there is no caption or link. O(output).
std::string placement_sketch(const ShownPlacement& of);

}  // namespace evenlift
