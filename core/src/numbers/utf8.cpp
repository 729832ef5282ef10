#include "numbers/utf8.h"

#include <algorithm>

namespace evenlift {

bool is_line_of_text(std::string_view line) {
  for (std::size_t i = 0; i < line.size();) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(line[k]); };
    const unsigned char first = byte(i);
    if ((first < 0x20 && first != '\t' && first != '\r') || first == 0x7f) return false;
    const std::size_t more = first < 0x80   ? 0
                             : first < 0xc2 ? 4
                             : first < 0xe0 ? 1
                             : first < 0xf0 ? 2
                             : first < 0xf5 ? 3
                                            : 4;
    if (more == 4 || i + more >= line.size()) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((byte(i + k) & 0xc0) != 0x80) return false;
    if (more > 1) {  // overlong, a surrogate, or beyond the last character
      const unsigned char second = byte(i + 1);
      if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
          (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
        return false;
    }
    i += more + 1;
  }
  return true;
}

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;  // not a further byte of a character
  }));
}

}  // namespace evenlift
