// One page: its state, what it draws, and the pending commands.
#pragma once

#include "actions/pointer.h"
#include "picture/scene.h"
#include "state/command.h"
#include "state/layout.h"
#include "state/state.h"

namespace evenlift::view {

struct App {
  AppState state;
  Layout layout;  // of the state, made by advance()
  Scene scene, second_scene;
  bool over_second = false;  // the pointer is over the second picture, or was pressed there
  Commands commands;
};

// The three parts of a frame, in order. Only the first and the last change the state.

// Applies the effects of the pointer and of time. `now` is in seconds. The cost is that of derive()
// (derive/derive.h).
void advance(App& app, const Pointer& pointer, double now);

// Draws what advance() has made, and returns the requests of the panels. Call it between
// ImGui::NewFrame() and ImGui::Render(). Without `picture`, only lays out the panels, so that input is
// processed before a frame is due. The panels cost the same for every polygon.
Commands draw_frame(const App& app, bool picture = true);

// Applies the commands. Returns whether there were any; if so, another frame is due.
bool settle(App& app);

}  // namespace evenlift::view
