// The functions that web/page calls: window.evenlift, the address bar, keys. All text is UTF-8; a
// returned text stays valid until the next call.
#pragma once

#include "app/app.h"

namespace evenlift::view {

// The only page.
App& app();

// Carries out the pending commands, and their requests to the browser. Returns whether there were
// any, in which case another frame is due.
bool settle();

// Carries out these commands at once, as if from a button.
void carry_out(Commands commands);

// Call after a function that changed the state in place of a command because it may refuse: does
// everything that follows a command.
void carried_out();

}  // namespace evenlift::view
