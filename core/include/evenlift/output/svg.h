// Draws a placement as an SVG picture for reports. The picture has no scripts and loads no fonts.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/report.h"

namespace evenlift {

// Draws the object, the robots with their loads, the centre of mass, and the chosen overlays
// (document.h) except the heat map and the tipping distance. By default the overlays are H, the
// chords and the two regions of free rotation centres. Their hatching distinguishes them without
// colour. A caption and a <title>/<desc> describe the placement in words. The bytes are the same on
// every platform. If `link` is the link of the document (link.h), evenlift can open the picture as
// that document. `cases` is the JSON of cases_json() (json.h) or empty, for a second <metadata>.
// O(output).
std::string placement_svg(const Reported& of, std::string_view link = {},
                          std::string_view cases = {});

// Draws the same picture at half the size, to be shown beside others. Letters and the robots' discs
// keep their size, and there is no caption or link. O(output).
std::string placement_sketch(const Reported& of);

}  // namespace evenlift
