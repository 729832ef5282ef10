// What the page opens with: the work of the last visit, a link, or a sample.
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

// Opens the link; if there is none or it cannot be read the work, with its draft as one more step;
// if that cannot be read either the sample. A link is one step after the work, which undo leads
// back to and which is not placed before. Returns why the link could not be read, or nothing. The
// cost of one placement.
std::string open_page(AppState& state, const LastVisit& visit, std::string_view sample);

}  // namespace evenlift::view
