#include "pointer.h"

#include <cmath>

#include "pick.h"

namespace evenlift::view {
namespace {

constexpr double still = 3;  // CSS pixels that a click may shake

void press(const AppState& state, const Pointer& pointer, Commands& commands) {
  Pick under = pick(state, pointer.at);
  if (under.kind == Pick::Kind::edge && pointer.double_pressed && !state.screen.embed) {
    const Vec2 at = rounded_to_pixels(state.camera, under.at);
    commands.push_back(InsertVertex{under.index, at});
    under = {Pick::Kind::vertex, under.index + 1, 0, at};  // and it can be dragged at once
  }
  const bool grip = under.kind == Pick::Kind::vertex || under.kind == Pick::Kind::centre;
  if (!grip) under.kind = Pick::Kind::ground;
  // From here on `at` is how far the pointer is off what it holds, so that nothing jumps.
  under.at = grip ? Vec2(state.camera.to_screen(under.at) - pointer.at) : pointer.at;
  commands.push_back(SetHeld{under});
  if (under.kind == Pick::Kind::vertex) commands.push_back(SelectVertex{under.index});
}

void drag(const AppState& state, const Pointer& pointer, Commands& commands) {
  const Pick& held = state.held;
  if (pointer.moved < still && !state.edit_open && held.kind != Pick::Kind::ground) return;
  const Vec2 to = rounded_to_pixels(state.camera, state.camera.to_world(pointer.at + held.at));
  if (held.kind == Pick::Kind::vertex) commands.push_back(MoveVertex{held.index, to});
  if (held.kind == Pick::Kind::centre) commands.push_back(MoveCentre{to});
  if (held.kind == Pick::Kind::ground && (pointer.at - held.at).norm() > 0) {
    commands.push_back(SetCamera{pan(state.camera, pointer.at - held.at)});
    Pick moved = held;
    moved.at = pointer.at;
    commands.push_back(SetHeld{moved});
  }
}

void release(const AppState& state, const Pointer& pointer, Commands& commands) {
  // A click on the ground lets go of the selection; a pan does not.
  if (state.held.kind == Pick::Kind::ground && pointer.moved < still)
    commands.push_back(SelectVertex{});
  commands.push_back(EndEdit{});
  commands.push_back(SetHeld{});
}

void pinch(const AppState& state, const Pointer& pointer, Commands& commands) {
  // What the first finger had taken hold of is let go where it is.
  if (state.held.kind != Pick::Kind::none) release(state, pointer, commands);
  const Camera moved = pan(state.camera, pointer.pinch_moved);
  commands.push_back(SetCamera{zoom(moved, pointer.pinch_at, pointer.pinch_factor, 0, 1e300)});
}

void hover(const AppState& state, const Pointer& pointer, Commands& commands) {
  const bool none = !pointer.present || pointer.over_panel || (state.screen.touch && !pointer.down);
  const Pick under = none ? Pick{} : pick(state, pointer.at);
  if (!(under == state.hover)) commands.push_back(SetHover{under});
}

}  // namespace

void interact(const AppState& state, const Pointer& pointer, Commands& commands) {
  if (pointer.pinching) return pinch(state, pointer, commands);
  const bool holding = state.held.kind != Pick::Kind::none;
  if (holding && pointer.down)
    drag(state, pointer, commands);
  else if (holding)
    release(state, pointer, commands);
  else if (pointer.pressed && !pointer.over_panel)
    press(state, pointer, commands);
  if (!holding) hover(state, pointer, commands);
  if (pointer.wheel != 0 && !pointer.over_panel) {
    const double factor = std::exp(pointer.wheel * 0.18);
    commands.push_back(SetCamera{zoom(state.camera, pointer.at, factor, 0, 1e300)});
  }
}

}  // namespace evenlift::view
