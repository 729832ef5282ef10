// The functions that web/page calls: window.evenlift, the address bar, keys. All text is UTF-8; a
// text that is returned stays valid until the next call.
#pragma once

#include "app/app.h"

namespace evenlift::view {

// The one page.
App& app();

}  // namespace evenlift::view
