#include "state/layout.h"

#include <algorithm>

namespace evenlift::view {
namespace {

constexpr double panel_width = 344, rail_width = 48, toolbar_height = 48;

// Room around the polygon for robots and their loads.
Rect room_in(const Rect& free, double beside, double above, double below) {
  const double x = std::min(beside, free.width() / 6), most = free.height() / 4;
  return {free.left + x, free.top + std::min(above, most), free.right - x,
          free.bottom - std::min(below, most)};
}

// Two pictures share the free room; each has a caption at its top.
void split(Layout& l, bool compared, double beside, double above, double below) {
  l.first = l.free;
  if (!compared) {
    l.room = room_in(l.free, beside, above, below);
    return;
  }
  l.second = l.free;
  if (l.wide)
    l.first.right = l.second.left = l.free.middle().x();
  else
    l.first.bottom = l.second.top = l.free.middle().y();
  const double caption = l.wide ? 64 : 40;
  l.room = room_in(l.first, beside * 0.8, above + caption, below * 0.8);
}

// Puts the player at the foot of the free room, and the tools of the view above it.
void seat_player(Layout& l, double right, double height) {
  l.player = {l.margin, l.free.bottom - l.margin - height, right, l.free.bottom - l.margin};
  l.tools.top -= height + l.margin;
  l.tools.bottom -= height + l.margin;
  l.free.bottom -= height + l.margin;
}

Layout embedded(const AppState& state) {
  const Screen& screen = state.screen;
  Layout l;
  l.margin = 12;
  l.control = screen.finger ? 44 : 32;
  l.wide = screen.width >= 640;
  l.free = {0, 0, screen.width, screen.height};
  if (walkthrough_is_open(state))
    seat_player(l, screen.width - l.margin,
                std::min(screen.height * 0.5, l.control * 2 + (l.wide ? 128 : 176)));
  l.toolbar = {l.margin, l.margin, screen.width, l.margin + toolbar_height};
  split(l, false, 72, 60, 60);
  return l;
}

Layout wide(const AppState& state) {
  Layout l;
  const Screen& screen = state.screen;
  const double width = state.panel_open ? panel_width : rail_width;
  l.control = screen.finger ? 44 : 32;
  l.panel = {screen.width - l.margin - width, l.margin, screen.width - l.margin,
             screen.height - l.margin};
  l.toolbar = {l.margin, l.margin, l.panel.left - l.margin, l.margin + toolbar_height};
  const double tools_width = 5 * l.control + 8 + 13 + 16, tools_height = l.control + 16;
  l.tools = {l.margin, screen.height - l.margin - tools_height, l.margin + tools_width,
             screen.height - l.margin};
  l.free = {0, l.toolbar.bottom, l.panel.left, screen.height};
  if (walkthrough_is_open(state)) seat_player(l, l.panel.left - l.margin, l.control * 2 + 24);
  if (state.tool == Tool::transform)
    l.free.top += l.control + 60;  // the tool's bar, and the turning knob
  split(l, state.second_method.has_value(), 88, 56, 84);
  return l;
}

Layout narrow(const AppState& state) {
  Layout l;
  const Screen& screen = state.screen;
  l.wide = false;
  l.control = 44;
  l.margin = 8;
  double height = std::min(state.closed_sheet_height, screen.height * 0.45);
  if (state.sheet == Sheet::half) height = screen.height * 0.45;
  if (state.sheet == Sheet::full) height = screen.height - toolbar_height - 3 * l.margin;
  l.panel = {0, screen.height - height, screen.width, screen.height};
  l.toolbar = {l.margin, l.margin, screen.width - l.margin, l.margin + toolbar_height};
  // A sheet that is pulled up to the top covers the drawing for a moment; the drawing does not
  // move.
  const double below = std::min(height, screen.height * 0.45);
  l.free = {0, l.toolbar.bottom, screen.width, screen.height - below};
  const double tools_height = 3 * 44 + 2 * 2 + 4;
  l.tools = {screen.width - l.margin - 48, l.panel.top - l.margin - tools_height,
             screen.width - l.margin, l.panel.top - l.margin};
  split(l, state.second_method.has_value(), 60, 52, 52);
  return l;
}

}  // namespace

Layout layout(const AppState& state) {
  const Screen& screen = state.screen;
  if (screen.embed) return embedded(state);
  // A phone on its side is wide, too: a sheet would leave nothing of the drawing.
  const bool side = screen.width >= 900 || (screen.width >= 640 && screen.width > screen.height);
  return side ? wide(state) : narrow(state);
}

}  // namespace evenlift::view
