// What the mouse pointer looks like over the drawing, so that it can be seen what a press would do.
#pragma once

#include "state/effects.h"
#include "state/state.h"

namespace evenlift::view {

Cursor cursor(const AppState& state);

}  // namespace evenlift::view
