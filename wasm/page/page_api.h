// What web/*.js calls: window.evenlift, the address bar, keys. Text goes both ways as UTF-8; what
// comes back stays valid until the next call.
#pragma once

#include "app/app.h"

namespace evenlift::view {

// The one page.
App& app();

}  // namespace evenlift::view
