// The first sample, embedded in the program so that it is available at once; the others come in a
// separate file. The build makes it from assets/polygons.
#pragma once

#include <string_view>

namespace evenlift::view {

std::string_view opening_sample();

}  // namespace evenlift::view
