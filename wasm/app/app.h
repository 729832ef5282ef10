// One page: its state, what it draws, and the pending commands.
#pragma once

#include "actions/pointer.h"
#include "picture/scene.h"
#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

struct App {
  AppState state;
  Scene scene, second_scene;
  bool over_second = false;  // the pointer is over the second picture, or was pressed there
  Commands commands;
};

// The three parts of a frame, in order. Only the first and the last change the state.

// Applies the effects of the pointer and of time. `now` is in seconds. The cost is that of derive()
// (derive/derive.h).
void advance(App& app, const Pointer& pointer, double now);

// Draws the state. Call it between ImGui::NewFrame() and ImGui::Render(). The panels' requests
// become commands. Without `picture`, only lays out the panels, so that input is processed before a
// frame is due. The layout costs the same for every polygon.
void draw_frame(App& app, bool picture = true);

// Applies the commands. Returns whether there were any; if so, another frame is due.
bool settle(App& app);

}  // namespace evenlift::view
