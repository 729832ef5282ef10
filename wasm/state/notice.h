// A notice over the drawing, which screen readers are told.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// One without a text takes the last one away. What says that something went wrong stays until it is
// closed or another one comes; others end after a while, since they cover a part of the drawing.
void show(AppState& state, Notice notice);
void end_notice(AppState& state);

}  // namespace evenlift::view
