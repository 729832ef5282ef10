// The marks of the first picture that explain themselves: where the pointer or a finger rests, or one
// after another by a key. marks/explained.cpp knows where each is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "state/state.h"

namespace evenlift::view {

// The marks that are in the first picture now, in the order of PictureMark. O(1).
std::vector<PictureMark> marks_in_picture(const AppState& state);

// The mark for which the key asked (View::explained), if it is in the picture. O(1).
std::optional<PictureMark> explained_mark(const AppState& state);

// What the mark means, in one or two sentences.
std::string mark_in_words(const AppState& state, PictureMark mark);

}  // namespace evenlift::view
