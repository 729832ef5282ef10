#include "panels/action_button.h"

#include <string>

#include "ui/widgets.h"

namespace evenlift::view {
namespace {

std::string about(const Action& a) {
  return *a.shown ? std::string(a.label) + " (" + a.shown + ")" : std::string(a.label);
}

}  // namespace

void action_button(const Ui& ui, ActionId id, float size) {
  const Action& a = action(id);
  if (icon_button(ui, a.label, a.icon, a.enabled(ui.state), about(a).c_str(), size))
    a.run(ui.state, ui.commands);
}

void named_action_button(const Ui& ui, ActionId id, float size) {
  const Action& a = action(id);
  if (text_button(ui, a.label, a.icon, a.label, about(a).c_str(), size))
    a.run(ui.state, ui.commands);
}

}  // namespace evenlift::view
