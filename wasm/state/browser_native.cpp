// Replaces the browser where the view is built natively, for its tests.
#include "state/browser.h"

namespace evenlift::view::browser {

void document_changed() {}
void summary_changed() {}
void preferences_changed() {}
void copy_address(std::string_view) {}
void open_dialog(Dialog) {}
void show_cursor(Cursor) {}
void type_value(std::string_view) {}
void announce(std::string_view) {}
void show_full_screen(bool) {}
void open_page() {}
void say_absent(std::string_view) {}
void fetch_letters() {}
void measure_screen() {}
void request_frame() {}
void request_frame_after(double) {}
void drop_frame_after() {}
void end_notice_after(std::optional<double>) {}
void begin_search(std::uint64_t, std::string_view, std::string_view, std::string_view) {}
void end_search() {}
void schedule_frame() {}

}  // namespace evenlift::view::browser
