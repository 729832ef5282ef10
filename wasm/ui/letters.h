// The characters of users' texts: lessons and file names. The page itself uses few characters, and
// at first has only these. When a text needs others, the page fetches larger fonts
// (web/page/bindings.js), and the requested characters are rasterised from them.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace evenlift::view {

// Notes the characters of a text in this font that the font lacks. O(bytes).
void note_letters(const ImFont& font, std::string_view text);

// Whether characters were noted but not yet looked up.
bool letters_are_due();

// Whether the larger fonts have arrived; call have_letters() when they do.
bool letters_are_here();
void have_letters();

// The ranges of characters to rasterise, ended by 0: the page's own, and a range around each noted
// character. Nothing is due afterwards.
const ImWchar* letter_ranges();

// The characters looked up in vain since the last call, as text. Call it after the fonts are built.
std::string absent_letters(const ImFont& font);

}  // namespace evenlift::view
