// The list of keys for people, from the table of actions.
#pragma once

#include <string>

namespace evenlift::view {

// A line for each action that has a key of its own: its group from 0, its key, and what it does, with
// tabs between them. Groups follow each other. With `embed` only what works in an <iframe>.
std::string key_list(bool embed);

}  // namespace evenlift::view
