// The first sample, embedded so that it is available at once; the others are in a file. The build
// makes it from assets/polygons.
#pragma once

#include <string_view>

namespace evenlift::view {

std::string_view opening_sample();

}  // namespace evenlift::view
