// The sample that the page opens on, in the program itself so that it is there at once; the others
// come as a file beside it. Made from assets/polygons by the build.
#pragma once

#include <string_view>

namespace evenlift::view {

std::string_view opening_sample();

}  // namespace evenlift::view
