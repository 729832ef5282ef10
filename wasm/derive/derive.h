// Derives AppState::derived(), which no other code writes.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Brings the facts up to date, once after each batch of commands. Derives only the facts whose
// basis (state/derived.h) changed, and the facts that follow from them. Slow work waits for the end
// of a drag. Uses the values that commands passed on (AppState::given), and asks the browser to
// search or to announce; changes nothing else. Costs at most one placement for the document and one
// for the second method; O(overlays) if nothing is out of date.
void derive(AppState& state);

}  // namespace evenlift::view
