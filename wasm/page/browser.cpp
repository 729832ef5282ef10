// Each function calls its namesake in web/page/bindings.js.
#include "page/browser.h"

#include <emscripten/emscripten.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <variant>

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
EM_JS(void, evenlift_choose_elsewhere,
      (double number, const double* rings, std::size_t size, const char* settings), {
        const at = rings >>> 0;
        Module["bindings"]["chooseElsewhere"](number, HEAPU8.slice(at, at + 8 * size),
                                              UTF8ToString(settings));
      })
EM_JS(void, evenlift_end_notice_after, (double seconds),
      { Module["bindings"]["endNoticeAfter"](seconds); })
EM_JS(void, evenlift_drop_frame_after, (), { Module["bindings"]["dropFrameAfter"](); })

namespace evenlift::view::browser {
namespace {

const char* name_of(Dialog dialog) {
  constexpr const char* names[] = {"samples",    "open",    "save",    "table", "lessons",
                                   "experiment", "curves",  "keys",    "about", "glossary",
                                   "welcome",    "optimum", "language"};
  static_assert(std::size(names) == static_cast<std::size_t>(Dialog::end_of_dialogs));
  return names[static_cast<std::size_t>(dialog)];
}

struct CarryOut {
  void operator()(const DocumentChanged&) const { evenlift_document_changed(); }
  void operator()(const SummaryChanged&) const { evenlift_summary_changed(); }
  void operator()(const PreferencesChanged&) const { evenlift_preferences_changed(); }
  void operator()(const Announce& e) const { evenlift_announce(e.text.c_str()); }
  void operator()(const CopyAddress& e) const { evenlift_copy_address(e.link.c_str()); }
  void operator()(const ShowDialog& e) const { evenlift_open_dialog(name_of(e.dialog)); }
  void operator()(const FocusField& e) const { evenlift_type_value(e.control.c_str()); }
  void operator()(const ShowFullScreen& e) const { evenlift_show_full_screen(e.on ? 1 : 0); }
  void operator()(const ShowPage&) const { evenlift_open_page(); }
  void operator()(const BeginSearch& e) const {
    evenlift_begin_search(static_cast<double>(e.number), e.polygon.c_str(), e.settings.c_str(),
                          e.robots.c_str());
  }
  void operator()(const EndSearch&) const { evenlift_end_search(); }
  void operator()(const ChooseElsewhere& e) const {
    evenlift_choose_elsewhere(static_cast<double>(e.number), e.rings.data(), e.rings.size(),
                              e.settings.c_str());
  }
  void operator()(const NextFrame&) const { request_frame(); }
  void operator()(const FrameAfter& e) const { evenlift_frame_after(e.seconds); }
  void operator()(const DropFrameAfter&) const { evenlift_drop_frame_after(); }
  void operator()(const EndNoticeAfter& e) const {
    evenlift_end_notice_after(e.seconds.value_or(-1));
  }
};

}  // namespace

void carry_out(const Effects& effects) {
  for (const Effect& effect : effects) std::visit(CarryOut{}, effect);
}

void show_cursor(Cursor cursor) {
  // As in CSS.
  constexpr const char* names[] = {"default",  "pointer", "crosshair",   "copy",       "grab",
                                   "grabbing", "move",    "nesw-resize", "nwse-resize"};
  static_assert(std::size(names) == static_cast<std::size_t>(Cursor::end_of_cursors));
  evenlift_show_cursor(names[static_cast<std::size_t>(cursor)]);
}
void say_absent(std::string_view characters) {
  evenlift_say_absent(std::string(characters).c_str());
}
void fetch_letters() { evenlift_fetch_letters(); }
void measure_screen() { evenlift_measure_screen(); }
void schedule_frame() { evenlift_schedule_frame(); }

}  // namespace evenlift::view::browser
