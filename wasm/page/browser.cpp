// Asks the browser through web/page/bindings.js: each function here calls the one of its name
// there.
#include "state/browser.h"

#include <emscripten/emscripten.h>

#include <cstddef>
#include <string>

EM_JS(void, evenlift_document_changed, (), { Module["bindings"]["documentChanged"](); })
EM_JS(void, evenlift_preferences_changed, (), { Module["bindings"]["preferencesChanged"](); })
EM_JS(void, evenlift_copy_address, (const char* link),
      { Module["bindings"]["copyAddress"](UTF8ToString(link)); })
EM_JS(void, evenlift_open_dialog, (const char* name),
      { Module["bindings"]["openDialog"](UTF8ToString(name)); })
EM_JS(void, evenlift_announce, (const char* text),
      { Module["bindings"]["announce"](UTF8ToString(text)); })
EM_JS(void, evenlift_open_page, (), { Module["bindings"]["openPage"](); })
EM_JS(void, evenlift_measure_screen, (), { Module["bindings"]["measureScreen"](); })
EM_JS(void, evenlift_schedule_frame, (), { Module["bindings"]["scheduleFrame"](); })
EM_JS(void, evenlift_frame_after, (double seconds), { Module["bindings"]["frameAfter"](seconds); })
EM_JS(void, evenlift_drop_frame_after, (), { Module["bindings"]["dropFrameAfter"](); })

namespace evenlift::view::browser {

void document_changed() { evenlift_document_changed(); }
void preferences_changed() { evenlift_preferences_changed(); }
void copy_address(std::string_view link) { evenlift_copy_address(std::string(link).c_str()); }
void open_dialog(Dialog dialog) {
  constexpr const char* names[] = {"samples", "open",       "save",  "table",
                                   "lessons", "experiment", "curves"};
  evenlift_open_dialog(names[static_cast<std::size_t>(dialog)]);
}
void announce(std::string_view text) { evenlift_announce(std::string(text).c_str()); }
void open_page() { evenlift_open_page(); }
void measure_screen() { evenlift_measure_screen(); }
void request_frame_after(double seconds) { evenlift_frame_after(seconds); }
void drop_frame_after() { evenlift_drop_frame_after(); }
void schedule_frame() { evenlift_schedule_frame(); }

}  // namespace evenlift::view::browser
