#include "ui/letters.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

namespace evenlift::view {
namespace {

// At least the characters of assets/fonts/subset.py that the page itself writes; those that a font
// lacks take no room.
constexpr ImWchar always[] = {0x20, 0xFF, 0x2009, 0x203A, 0x2212, 0x2265};

// Rasterised together, since a text seldom needs one character alone.
constexpr unsigned block = 0x80;
constexpr unsigned beyond = 0x10000;  // Dear ImGui's characters have 16 bits

struct Letters {
  std::set<unsigned> wanted, sought;  // characters
  std::vector<ImWchar> ranges;
  bool here = false;
};
Letters letters;

struct Decoded {
  unsigned character;
  std::size_t bytes;
};

// Of a non-empty UTF-8 text; stray and truncated bytes are decoded singly.
Decoded decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t bytes = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (bytes == 1 || bytes > text.size()) return {first, 1};
  unsigned character = first & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) character = character << 6 | (byte(i) & 0x3Fu);
  return {character, bytes};
}

std::string encode(unsigned c) {
  std::string text;
  if (c < 0x800) {
    text += static_cast<char>(0xC0 | c >> 6);
  } else {
    if (c < beyond) {
      text += static_cast<char>(0xE0 | c >> 12);
    } else {
      text += static_cast<char>(0xF0 | c >> 18);
      text += static_cast<char>(0x80 | (c >> 12 & 0x3F));
    }
    text += static_cast<char>(0x80 | (c >> 6 & 0x3F));
  }
  text += static_cast<char>(0x80 | (c & 0x3F));
  return text;
}

bool has(const ImFont& font, unsigned c) {
  return c < beyond && font.FindGlyphNoFallback(static_cast<ImWchar>(c)) != nullptr;
}

}  // namespace

void note_letters(const ImFont& font, std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [c, bytes] = decode(text.substr(at));
    at += bytes;
    if (c >= 0x80 && !has(font, c) && !letters.sought.contains(c)) letters.wanted.insert(c);
  }
}

bool letters_are_due() { return !letters.wanted.empty(); }
bool letters_are_here() { return letters.here; }
void have_letters() { letters.here = true; }

const ImWchar* letter_ranges() {
  if (letters.here) letters.sought.merge(letters.wanted);
  letters.wanted.clear();
  std::set<unsigned> blocks;
  for (const unsigned c : letters.sought)
    if (c < beyond) blocks.insert(c / block);
  letters.ranges.assign(std::begin(always), std::end(always));
  for (const unsigned b : blocks) {
    letters.ranges.push_back(static_cast<ImWchar>(std::max(b * block, 0x20u)));
    letters.ranges.push_back(static_cast<ImWchar>(b * block + block - 1));
  }
  letters.ranges.push_back(0);
  return letters.ranges.data();
}

std::string absent_letters(const ImFont& font) {
  static std::set<unsigned> told;
  std::string text;
  for (const unsigned c : letters.sought)
    if (!has(font, c) && told.insert(c).second) text += encode(c);
  return text;
}

}  // namespace evenlift::view
