#include "state/notice.h"

#include <optional>
#include <string>
#include <utility>

#include "state/browser.h"

namespace evenlift::view {

namespace {

// Long enough to be read twice, at 15 letters a second.
double reading_time(const std::string& text) {
  return 4 + 2 * static_cast<double>(text.size()) / 15;
}

}  // namespace

void show(AppState& state, Notice notice) {
  // What is refused again is told again, but not for each point of a drag.
  const bool again = notice.kind == Notice::Kind::problem && !state.edit_open;
  if (again || notice.text != state.notice.text) browser::announce(notice.text);
  state.notice = std::move(notice);
  const bool ends = !state.notice.text.empty() && state.notice.kind == Notice::Kind::info;
  browser::end_notice_after(ends ? std::optional(reading_time(state.notice.text)) : std::nullopt);
}

void end_notice(AppState& state) {
  if (state.notice.kind == Notice::Kind::info) state.notice = {};
}

}  // namespace evenlift::view
