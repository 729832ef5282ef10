// The button of an enabled action (actions.h), with its icon, and its name and key on hovering; or
// a row of an open list.
#pragma once

#include "actions/actions.h"
#include "ui/ui.h"

namespace evenlift::view {

void action_button(const Ui& ui, ActionId id, float size);

// With the name beside the icon.
void named_action_button(const Ui& ui, ActionId id, float size);

// With the key if there may be a keyboard.
void action_row(const Ui& ui, ActionId id);

}  // namespace evenlift::view
