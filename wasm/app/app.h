// One page: its state, what it draws from it, and what was asked for since.
#pragma once

#include "actions/pointer.h"
#include "canvas/scene.h"
#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

struct App {
  AppState state;
  Scene scene, other_scene;
  bool over_other = false;  // where the pointer was pressed, or hovers
  Commands commands;
};

// Everything between ImGui::NewFrame() and ImGui::Render(): what the pointer does takes effect at
// once, what a panel asks for after the frame, by settle(). Without a `picture` only the panels are
// laid out, to deal with input that came before a frame is due; that costs the same for every
// polygon.
void draw_frame(App& app, const Pointer& pointer, bool picture = true);

// Applies what was asked for. Returns whether another frame is due.
bool settle(App& app);

}  // namespace evenlift::view
