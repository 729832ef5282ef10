// The list of keys for people, from the table of actions.
#pragma once

#include <vector>

#include "actions/actions.h"

namespace evenlift::view {

// The actions that have a key of their own, group after group. With `embed` only what works in an
// <iframe>.
std::vector<const Action*> key_list(bool embed);

}  // namespace evenlift::view
