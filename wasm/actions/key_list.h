// The readable list of keys, from the table of actions.
#pragma once

#include <vector>

#include "actions/actions.h"

namespace evenlift::view {

// The actions with a key of their own, group after group. With `embed`, only actions that work in
// an <iframe>.
std::vector<const Action*> key_list(bool embed);

}  // namespace evenlift::view
