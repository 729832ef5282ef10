// Asks the browser through web/page/bindings.js: each function here calls the one of its name
// there.
#include "state/browser.h"

#include <emscripten/emscripten.h>

#include <cstddef>
#include <iterator>
#include <string>

EM_JS(void, evenlift_document_changed, (), { Module["bindings"]["documentChanged"](); })
EM_JS(void, evenlift_summary_changed, (), { Module["bindings"]["summaryChanged"](); })
EM_JS(void, evenlift_preferences_changed, (), { Module["bindings"]["preferencesChanged"](); })
EM_JS(void, evenlift_copy_address, (const char* link),
      { Module["bindings"]["copyAddress"](UTF8ToString(link)); })
EM_JS(void, evenlift_open_dialog, (const char* name),
      { Module["bindings"]["openDialog"](UTF8ToString(name)); })
EM_JS(void, evenlift_show_cursor, (const char* name),
      { Module["bindings"]["showCursor"](UTF8ToString(name)); })
EM_JS(void, evenlift_type_value, (const char* control),
      { Module["bindings"]["typeValue"](UTF8ToString(control)); })
EM_JS(void, evenlift_announce, (const char* text),
      { Module["bindings"]["announce"](UTF8ToString(text)); })
EM_JS(void, evenlift_show_full_screen, (int on),
      { Module["bindings"]["showFullScreen"](Boolean(on)); })
EM_JS(void, evenlift_open_page, (), { Module["bindings"]["openPage"](); })
EM_JS(void, evenlift_say_absent, (const char* characters),
      { Module["bindings"]["sayAbsent"](UTF8ToString(characters)); })
EM_JS(void, evenlift_fetch_letters, (), { Module["bindings"]["fetchLetters"](); })
EM_JS(void, evenlift_measure_screen, (), { Module["bindings"]["measureScreen"](); })
EM_JS(void, evenlift_schedule_frame, (), { Module["bindings"]["scheduleFrame"](); })
EM_JS(void, evenlift_frame_after, (double seconds), { Module["bindings"]["frameAfter"](seconds); })
EM_JS(void, evenlift_begin_search,
      (double number, const char* polygon, const char* settings, const char* robots), {
        Module["bindings"]["beginSearch"](number, UTF8ToString(polygon), UTF8ToString(settings),
                                          UTF8ToString(robots));
      })
EM_JS(void, evenlift_end_search, (), { Module["bindings"]["endSearch"](); })
EM_JS(void, evenlift_end_notice_after, (double seconds),
      { Module["bindings"]["endNoticeAfter"](seconds); })
EM_JS(void, evenlift_drop_frame_after, (), { Module["bindings"]["dropFrameAfter"](); })

namespace evenlift::view::browser {

void document_changed() { evenlift_document_changed(); }
void summary_changed() { evenlift_summary_changed(); }
void preferences_changed() { evenlift_preferences_changed(); }
void copy_address(std::string_view link) { evenlift_copy_address(std::string(link).c_str()); }
void open_dialog(Dialog dialog) {
  constexpr const char* names[] = {"samples", "open", "save",  "table",    "lessons", "experiment",
                                   "curves",  "keys", "about", "glossary", "welcome", "optimum"};
  static_assert(std::size(names) == static_cast<std::size_t>(Dialog::end_of_dialogs));
  evenlift_open_dialog(names[static_cast<std::size_t>(dialog)]);
}
void show_cursor(Cursor cursor) {
  // As style sheets name them.
  constexpr const char* names[] = {"default",  "pointer", "crosshair",   "copy",       "grab",
                                   "grabbing", "move",    "nesw-resize", "nwse-resize"};
  static_assert(std::size(names) == static_cast<std::size_t>(Cursor::end_of_cursors));
  evenlift_show_cursor(names[static_cast<std::size_t>(cursor)]);
}
void type_value(std::string_view control) { evenlift_type_value(std::string(control).c_str()); }
void announce(std::string_view text) { evenlift_announce(std::string(text).c_str()); }
void show_full_screen(bool on) { evenlift_show_full_screen(on ? 1 : 0); }
void open_page() { evenlift_open_page(); }
void say_absent(std::string_view characters) {
  evenlift_say_absent(std::string(characters).c_str());
}
void fetch_letters() { evenlift_fetch_letters(); }
void measure_screen() { evenlift_measure_screen(); }
void request_frame_after(double seconds) { evenlift_frame_after(seconds); }
void drop_frame_after() { evenlift_drop_frame_after(); }
void end_notice_after(std::optional<double> seconds) {
  evenlift_end_notice_after(seconds.value_or(-1));
}
void begin_search(std::uint64_t number, std::string_view polygon, std::string_view settings,
                  std::string_view robots) {
  evenlift_begin_search(static_cast<double>(number), std::string(polygon).c_str(),
                        std::string(settings).c_str(), std::string(robots).c_str());
}
void end_search() { evenlift_end_search(); }
void schedule_frame() { evenlift_schedule_frame(); }

}  // namespace evenlift::view::browser
