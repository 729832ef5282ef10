#include "actions/key_list.h"

#include "actions/actions.h"
#include "actions/when.h"

namespace evenlift::view {
std::string key_list(bool embed) {
  std::string text;
  for (const Group group :
       {Group::files, Group::editing, Group::teams, Group::view, Group::lesson, Group::help}) {
    if (embed && group < Group::view) continue;
    for (const Action& a : actions()) {
      if (*a.shown && a.group == group && !(embed && a.enabled == when::editing))
        text += std::to_string(static_cast<int>(group)) + '\t' + a.shown + '\t' + a.label + '\n';
    }
  }
  return text;
}

}  // namespace evenlift::view
