// The functions that web/page calls: window.evenlift, the address bar, keys. All text is UTF-8; a
// text that is returned stays valid until the next call.
#pragma once

#include "app/app.h"

namespace evenlift::view {

// The one page.
App& app();

// Carries out commands at once, as if a button had asked for them.
void carry_out(Commands commands);

}  // namespace evenlift::view
