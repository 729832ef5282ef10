#include "tools/pick.h"

#include "tools/pick.h"
#include "tools/transform.h"

namespace evenlift::view {
namespace {

Cursor over_frame(FrameGrip grip, bool held) {
  switch (grip) {
    case FrameGrip::low_left:
    case FrameGrip::high_right:
      return Cursor::resize_rising;
    case FrameGrip::low_right:
    case FrameGrip::high_left:
      return Cursor::resize_falling;
    case FrameGrip::turn:
      return held ? Cursor::grabbing : Cursor::grab;
    case FrameGrip::inside:
      break;
  }
  return Cursor::move;
}

}  // namespace

Cursor cursor(const AppState& state) {
  const bool holds = state.view.held.kind != Pick::Kind::none;
  if (draws(state.view.tool)) {
    if (state.view.held.kind == Pick::Kind::vertex) return Cursor::grabbing;
    return state.view.hover.kind == Pick::Kind::vertex ? Cursor::grab : Cursor::crosshair;
  }
  const Pick& at = holds ? state.view.held : state.view.hover;
  switch (at.kind) {
    case Pick::Kind::vertex:
    case Pick::Kind::centre:
    case Pick::Kind::cargo:
    case Pick::Kind::left_out:
    case Pick::Kind::uncertainty:
      return holds ? Cursor::grabbing : Cursor::grab;
    case Pick::Kind::frame:
      return over_frame(static_cast<FrameGrip>(at.index), holds);
    case Pick::Kind::edge:
      return state.session.screen.embed ? Cursor::arrow : Cursor::add;
    case Pick::Kind::robot:
      if (can_take_robot(state, at)) return holds ? Cursor::grabbing : Cursor::grab;
      return Cursor::press;
    case Pick::Kind::chord:
    case Pick::Kind::candidate:
      return Cursor::press;
    case Pick::Kind::ground:
      return Cursor::grabbing;
    case Pick::Kind::object:
    case Pick::Kind::none:
      break;
  }
  return walkthrough_is_open(state) && state.view.walkthrough.hovered ? Cursor::press
                                                                      : Cursor::arrow;
}

}  // namespace evenlift::view
