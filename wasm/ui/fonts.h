// The page's two fonts: assets/fonts, which cmake/Embed.cmake embeds, or larger ones that the page
// fetched.
#pragma once

#include <vector>

namespace evenlift::view {

struct FontData {
  const unsigned char* bytes;
  int size;
};

FontData regular_font();
FontData semibold_font();

// See letters.h.
void give_fonts(std::vector<unsigned char> regular, std::vector<unsigned char> semibold);

}  // namespace evenlift::view
