// Shows an action (actions.h) as a button or as a row of an open list. A button shows the icon of
// the action and, on hovering, its name and key.
#pragma once

#include "actions/actions.h"
#include "ui/ui.h"

namespace evenlift::view {

void action_button(const Ui& ui, ActionId id, float size);

// A button with the name beside the icon. The action must be enabled.
void named_action_button(const Ui& ui, ActionId id, float size);

// A row with the name, and with the key if there may be a keyboard.
void action_row(const Ui& ui, ActionId id);

}  // namespace evenlift::view
