// Replaces the browser where the view is built natively, for its tests.
#include "state/browser.h"

namespace evenlift::view::browser {

void document_changed() {}
void preferences_changed() {}
void copy_address(std::string_view) {}
void open_dialog(Dialog) {}
void announce(std::string_view) {}
void open_page() {}
void measure_screen() {}
void request_frame() {}
void request_frame_after(double) {}
void drop_frame_after() {}
void schedule_frame() {}

}  // namespace evenlift::view::browser
