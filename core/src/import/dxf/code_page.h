// The letters of DXF drawings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace evenlift {

// A drawing's text as UTF-8. Before 2007 programs wrote the letters of the code page that
// $DWGCODEPAGE names: Windows 874, 932, 936, 949, 950 and 1250 to 1258.
struct DxfLetters {
  std::optional<std::string>
      text;             // if it had to be converted. Bytes without a letter become U+FFFD
  std::string unknown;  // the name of a code page that is not known here
};

// Converts a text that is not UTF-8 yet; lines keep their numbers. O(bytes).
DxfLetters in_utf8(std::string_view text);

// A name with the letters for which programs write \U+00DF, where their code page has none. O(bytes).
std::string with_letters(std::string_view name);

}  // namespace evenlift
