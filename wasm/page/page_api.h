// The functions that web/page calls: window.evenlift, the address bar, keys. All text is UTF-8; a
// text that is returned stays valid until the next call.
#pragma once

#include "app/app.h"

namespace evenlift::view {

// The one page.
App& app();

// Carries out the commands since, and what they ask of the browser. Returns whether there were any;
// then another frame is due.
bool settle();

// Carries out these commands at once, as if a button had asked for them.
void carry_out(Commands commands);

// Does what follows after a function that changed the state in place of a command, since it may
// refuse to.
void carried_out();

}  // namespace evenlift::view
