#include "panels/action_button.h"

#include <optional>
#include <string>

#include "evenlift/wording.h"
#include "widgets/buttons.h"
#include "widgets/dropdown.h"
#include "widgets/text.h"

namespace evenlift::view {

namespace {

// Nothing for actions without a tool.
std::optional<bool> is_on(ActionId id, const AppState& state) {
  if (id == ActionId::draw) return draws(state.view.tool) || state.view.tool == Tool::weight;
  if (id == ActionId::transform) return state.view.tool == Tool::transform;
  if (id == ActionId::add_robots) return state.view.tool == Tool::robot;
  if (id == ActionId::mark) return state.view.tool == Tool::mark;
  return std::nullopt;
}

}  // namespace

void action_button(const Ui& ui, ActionId id, float size) {
  const Action& a = action(id);
  if (icon_button(ui, a.label, a.icon, a.enabled(ui.state), tip(a, ui.state).c_str(), size,
                  is_on(id, ui.state)))
    a.run(ui.state, ui.commands);
}

void named_action_button(const Ui& ui, ActionId id, float size) {
  const Action& a = action(id);
  if (text_button(ui, a.label, a.icon, a.label, tip(a, ui.state).c_str(), size, Icon::none,
                  is_on(id, ui.state)))
    a.run(ui.state, ui.commands);
}

void action_row(const Ui& ui, ActionId id) {
  const Action& a = action(id);
  const bool keyed = *a.shown && !ui.state.session.screen.touch && !ui.state.session.screen.finger;
  const std::string name = keyed ? std::string(a.label) + " (" + a.shown + ")" : a.label;
  const std::string label = keyed ? say("{action} ({key})", {a.label, a.shown}) : a.label;
  if (choice(ui, label, nullptr, false, a.icon, a.enabled(ui.state), name))
    a.run(ui.state, ui.commands);
}

}  // namespace evenlift::view
