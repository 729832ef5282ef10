// Finds characters for users' texts, such as lessons and file names. At first the page's fonts have
// only the few characters that the page itself writes. The page fetches larger fonts
// (web/page/bindings.js), from which other characters are rasterised.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace evenlift::view {

// Notes which characters of the text the font lacks. O(bytes).
void note_letters(const ImFont& font, std::string_view text);

// Returns whether any noted characters have yet to be looked up in the fonts.
bool letters_are_due();

// letters_are_here() returns whether the larger fonts have arrived. Call have_letters() when they
// arrive.
bool letters_are_here();
void have_letters();

// Returns the ranges of characters to rasterise, ended by 0: the page's own characters and, once
// the larger fonts are here, a range around each noted character. No letters are due afterwards.
const ImWchar* letter_ranges();

// Returns, as text, the noted characters that the font lacks and that no earlier call returned.
// Call this after the fonts are built.
std::string absent_letters(const ImFont& font);

}  // namespace evenlift::view
