// The letters of texts that people wrote: lessons and names of files. The page itself writes few
// characters, and has only these at first. When a text is drawn that needs others, the page fetches
// larger fonts (web/page/bindings.js), and the characters that were asked for are rasterised from
// them.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace evenlift::view {

// Notes the characters of a text that is being drawn in this font and that the font lacks.
// O(bytes).
void note_letters(const ImFont& font, std::string_view text);

// Whether characters were noted that have not been looked for yet.
bool letters_are_due();

// Whether the larger fonts are there; call have_letters() when they are.
bool letters_are_here();
void have_letters();

// The ranges of characters to rasterise, ended by 0: those of the page, and around each one that
// was noted. Nothing is due afterwards.
const ImWchar* letter_ranges();

// The characters that were looked for in vain since the last call, as text; call after the fonts
// are built.
std::string absent_letters(const ImFont& font);

}  // namespace evenlift::view
