// Derives AppState::derived(), which no other code writes.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Brings the facts up to date. Call it once after each batch of commands. Derives only the facts
// whose basis (state/derived.h) changed, and the facts that follow from them. Slow work waits for
// the end of a drag. Takes the values that commands passed on (AppState::given), and appends
// requests to the browser, such as to search or to announce, to Session::effects. Changes nothing
// else. Costs at most one placement for the document, one for the second method and, if no drag is
// under way, the offer (offer.h) and the plan for a capacity. Costs O(overlays) if all is current.
void derive(AppState& state);

}  // namespace evenlift::view
