// The page's two fonts: those of assets/fonts, which cmake/Embed.cmake embeds, or larger ones that
// the page fetched.
#pragma once

#include <vector>

namespace evenlift::view {

struct FontData {
  const unsigned char* bytes;
  int size;  // in bytes
};

FontData regular_font();
FontData semibold_font();

// Replaces the fonts by larger ones that the page fetched (letters.h).
void give_fonts(std::vector<unsigned char> regular, std::vector<unsigned char> semibold);

}  // namespace evenlift::view
