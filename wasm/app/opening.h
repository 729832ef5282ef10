// What the page shows first: a link, the work of the last visit, or a sample.
#pragma once

#include <string>
#include <string_view>

#include "state/state.h"

namespace evenlift::view {

// What the address and the browser's storage hold; each may be empty, and any may be damaged.
struct LastVisit {
  std::string_view link;   // the address's fragment
  std::string_view work;   // the document that was placed last, as a link or a text
  std::string_view draft;  // a link of what was being edited when it was refused
};

// Opens the link. Without a link that can be read, opens the work, with its draft as a further step
// of undo; without work that can be read, the sample. Undo leads from a link back to the work,
// which is not placed before that. Returns why the link could not be read, or nothing. Costs one
// placement.
std::string open_page(AppState& state, const LastVisit& visit, std::string_view sample);

}  // namespace evenlift::view
