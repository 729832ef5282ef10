// The page's two fonts: assets/fonts, made part of the program by cmake/Embed.cmake.
#pragma once

namespace evenlift::view {

struct FontData {
  const unsigned char* bytes;
  int size;
};

FontData regular_font();
FontData semibold_font();

}  // namespace evenlift::view
