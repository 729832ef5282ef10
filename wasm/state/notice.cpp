#include "state/notice.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "evenlift/wording.h"

namespace evenlift::view {

namespace {

// Enough to read the text twice, at 15 letters a second.
double reading_time(std::string_view text) { return 4 + 2 * static_cast<double>(text.size()) / 15; }

}  // namespace

void emit(AppState& state, Effect effect) { state.session.effects.push_back(std::move(effect)); }

void announce(AppState& state, std::string text) {
  emit(state, Announce{std::string(translated(text))});
}

void show(AppState& state, Notice notice) {
  // A repeated refusal is announced again, but not for each point of a drag.
  const bool again = notice.kind == Notice::Kind::problem && !state.work.edit_open;
  if (again || notice.text != state.session.notice.text) announce(state, notice.text);
  state.session.notice = std::move(notice);
  const bool ends =
      !state.session.notice.text.empty() && state.session.notice.kind == Notice::Kind::info;
  emit(state,
       EndNoticeAfter{ends ? std::optional(reading_time(translated(state.session.notice.text)))
                           : std::nullopt});
}

void end_notice(AppState& state) {
  if (state.session.notice.kind == Notice::Kind::info) state.session.notice = {};
}

}  // namespace evenlift::view
