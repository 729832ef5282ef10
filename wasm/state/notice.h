// A notice over the drawing, which screen readers are told.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// One without a text takes the last one away.
void show(AppState& state, Notice notice);

}  // namespace evenlift::view
