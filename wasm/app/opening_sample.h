// The first sample, embedded so that it is available at once; the other samples are in a file. The
// build makes the embedded text from assets/polygons.
#pragma once

#include <string_view>

namespace evenlift::view {

std::string_view opening_sample();

}  // namespace evenlift::view
