#pragma once

#include <vector>

#include "actions/actions.h"

namespace evenlift::view {

// The actions with a key, by group. With `embed`, only the actions that work in an <iframe>.
std::vector<const Action*> key_list(bool embed);

}  // namespace evenlift::view
