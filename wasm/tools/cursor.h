// Chooses the pointer's shape, which shows what a press on the drawing would do.
#pragma once

#include "state/effects.h"
#include "state/state.h"

namespace evenlift::view {

Cursor cursor(const AppState& state);

}  // namespace evenlift::view
