// The button of an action (actions.h): its icon, its name and key on hovering, and whether it can
// be pressed now.
#pragma once

#include "actions/actions.h"
#include "ui/ui.h"

namespace evenlift::view {

void action_button(const Ui& ui, ActionId id, float size);

// With the action's name beside the icon.
void named_action_button(const Ui& ui, ActionId id, float size);

}  // namespace evenlift::view
