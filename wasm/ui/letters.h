// The characters of users' texts: lessons and file names. At first the page has only its own few.
// For others it fetches larger fonts (web/page/bindings.js), from which they are rasterised.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace evenlift::view {

// Notes the characters of a text that the font lacks. O(bytes).
void note_letters(const ImFont& font, std::string_view text);

// Whether noted characters were not yet looked up.
bool letters_are_due();

// Call have_letters() when the larger fonts arrive.
bool letters_are_here();
void have_letters();

// To rasterise, ended by 0: the page's own, and a range around each noted character. Nothing is due
// afterwards.
const ImWchar* letter_ranges();

// Looked up in vain since the last call, as text. Call it after the fonts are built.
std::string absent_letters(const ImFont& font);

}  // namespace evenlift::view
