// The functions that web/page calls: window.evenlift, the address bar, keys. All text is UTF-8; a
// returned text stays valid until the next call.
#pragma once

#include "app/app.h"

namespace evenlift::view {

App& app();

// Carries out the pending commands and their requests to the browser. Returns whether there were
// any.
bool settle();

// Carries out these commands at once, as if they came from a button.
void carry_out(Commands commands);

// Does everything that follows a command. Call it after a function that changed the state in place
// of a command because the function may refuse.
void carried_out();

}  // namespace evenlift::view
