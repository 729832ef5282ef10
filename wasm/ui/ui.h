// The context of the panels: every panel reads the state and adds commands.
#pragma once

#include "state/command.h"
#include "state/layout.h"
#include "state/state.h"
#include "ui/theme.h"

namespace evenlift::view {

struct Ui {
  const AppState& state;
  const Theme& theme;
  const Layout& layout;
  Commands& commands;
  Pick& row;  // the part that the hovered row of a panel names

  void push(Command command) const { commands.push_back(std::move(command)); }
  float control() const { return static_cast<float>(layout.control); }
};

}  // namespace evenlift::view
