// The first content of the page: a link, the last visit's work, or a sample.
#pragma once

#include <string>
#include <string_view>

#include "state/state.h"

namespace evenlift::view {

// Texts from the address and the browser's storage. Each may be empty or damaged.
struct LastVisit {
  std::string_view link;   // the address's fragment
  std::string_view work;   // the last placed document, as a link or a text
  std::string_view draft;  // a link to a document that was refused while it was being edited
};

// Opens the link if it can be read; otherwise opens the last work and then, as one step of undo,
// the draft; opens the sample if neither link nor work can be read. After a link has opened, undo
// opens the last work, which is placed only then. Returns why the link could not be read, or an
// empty text. Costs one placement, or two with a draft.
std::string open_page(AppState& state, const LastVisit& visit, std::string_view sample);

}  // namespace evenlift::view
