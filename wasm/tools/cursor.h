// The shape of the mouse pointer over the drawing, which shows what a press would do.
#pragma once

#include "state/effects.h"
#include "state/state.h"

namespace evenlift::view {

Cursor cursor(const AppState& state);

}  // namespace evenlift::view
