#include "state/notice.h"

#include <utility>

#include "state/browser.h"

namespace evenlift::view {

void show(AppState& state, Notice notice) {
  if (notice.text != state.notice.text) browser::announce(notice.text);
  state.notice = std::move(notice);
}

}  // namespace evenlift::view
