// What follows from the document and from what somebody looks at. Nothing else writes
// AppState::derived().
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Brings the facts up to date, once after each batch of commands: what differs from the basis of
// the last time (state/derived.h) is computed anew, and what follows from that. During a drag what
// would hold it up waits for its end. Takes what the commands brought along (AppState::given), and
// asks the browser to search or to announce; it changes nothing else. One placement at most for the
// document, and one for the second method; O(overlays) if nothing is out of date.
void derive(AppState& state);

}  // namespace evenlift::view
