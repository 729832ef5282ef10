#include "actions/key_list.h"

#include <algorithm>

#include "actions/when.h"

namespace evenlift::view {

std::vector<const Action*> key_list(bool embed) {
  std::vector<const Action*> list;
  for (const Action& a : actions()) {
    const bool left_out = embed && (a.group < Group::view || a.enabled == when::editing);
    if (*a.shown && !left_out) list.push_back(&a);
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Action* a, const Action* b) { return a->group < b->group; });
  return list;
}

}  // namespace evenlift::view
