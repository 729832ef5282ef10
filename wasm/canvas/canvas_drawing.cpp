#include "canvas/canvas_drawing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "evenlift/output/words.h"
#include "tools/drawing.h"
#include "tools/transform.h"

namespace evenlift::view {
namespace {

ImVec2 vec(const Vec2& p) { return {static_cast<float>(p.x()), static_cast<float>(p.y())}; }

// The chain with the edge under way.
Points chain_with_cursor(const AppState& state, bool closing) {
  Points chain = state.drawing.points;
  if (closing)
    chain.push_back(chain.front());
  else if (state.drawing.cursor)
    chain.push_back(*state.drawing.cursor);
  return chain;
}

std::string length_text(const AppState& state, const Vec2& from, const Vec2& to) {
  const double step = grid_step(state.camera);
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 0, 6);
  return given_point(to) + " · " + fixed(length(to - from), decimals) + " long";
}

Rect window_of(const AppState& state) { return {0, 0, state.screen.width, state.screen.height}; }

// Before the first vertex is placed.
void draw_first_cursor(const Painter& painter, const AppState& state, const Theme& theme) {
  const std::optional<Vec2>& cursor = state.drawing.cursor;
  if (!cursor) return;
  painter.list().AddCircleFilled(painter.at(*cursor), 4, theme.accent.packed(), 16);
  draw_word(painter.list(), state.camera.to_screen(*cursor), window_of(state), theme,
            theme.second_text, given_point(*cursor));
}

// The edges of the chain that cross another one.
std::set<std::size_t> crossed_edges(const Points& chain) {
  std::set<std::size_t> crossed;
  for (const auto& [i, j] : crossings(chain)) {
    crossed.insert(i);
    crossed.insert(j);
  }
  return crossed;
}

void draw_chain(const Painter& painter, const AppState& state, const Theme& theme,
                const Points& chain, const std::set<std::size_t>& crossed) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const bool placed = i + 1 < state.drawing.points.size();
    const Colour colour = crossed.count(i) ? theme.amber
                          : placed         ? theme.object_outline
                                           : theme.accent;
    painter.line(chain[i], chain[i + 1], colour, crossed.count(i) ? 3.5f : 2);
  }
}

// The vertices that are placed; a press on the first one would close the shape.
void draw_placed(const Painter& painter, const Drawing& drawing, const Theme& theme, bool closing) {
  ImDrawList& list = painter.list();
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    const ImVec2 at = painter.at(drawing.points[i]);
    const bool first = i == 0 && drawing.points.size() >= 3;
    if (first)
      list.AddCircleFilled(at, static_cast<float>(closing_reach),
                           theme.accent.at(closing ? 0.45f : 0.18f).packed(), 32);
    list.AddCircleFilled(at, 4.5f, theme.panel.packed(), 20);
    list.AddCircle(at, 4.5f, (first ? theme.accent : theme.object_outline).packed(), 20, 2);
  }
}

}  // namespace

void draw_word(ImDrawList& list, const Vec2& spot, const Rect& window, const Theme& theme,
               Colour colour, const std::string& text) {
  const ImVec2 size = text_size(Face::strong_label, text);
  const double width = static_cast<double>(size.x) + 16, height = static_cast<double>(size.y) + 10;
  const double left = std::clamp(spot.x() + 14, window.left + 4,
                                 std::max(window.left + 4, window.right - width - 4));
  double top = spot.y() - height - 10;
  if (top < window.top + 4) top = spot.y() + 18;
  const ImVec2 low = vec({left, top}), high = vec({left + width, top + height});
  list.AddRectFilled(low, high, theme.panel.at(0.95f).packed(), 6);
  list.AddRect(low, high, colour.at(0.5f).packed(), 6, 0, 1);
  draw_text(list, Face::strong_label, ImVec2(low.x + 8, low.y + 5), colour, text);
}

void draw_drawing(const Painter& painter, const AppState& state, const Theme& theme) {
  const Drawing& drawing = state.drawing;
  if (drawing.points.empty()) return draw_first_cursor(painter, state, theme);
  const bool closing = drawing.cursor && closes(state, state.camera.to_screen(*drawing.cursor));
  const Points chain = chain_with_cursor(state, closing);
  const std::set<std::size_t> crossed = crossed_edges(chain);
  draw_chain(painter, state, theme, chain, crossed);
  // What would close it now.
  if (!closing && chain.size() >= 3) painter.dashes(chain.back(), chain.front(), theme.quiet, 1.2f);
  draw_placed(painter, drawing, theme, closing);
  if (!drawing.cursor) return;
  const Vec2 spot = state.camera.to_screen(*drawing.cursor);
  const Rect window = window_of(state);
  if (closing) {
    draw_word(painter.list(), spot, window, theme, theme.accent, "Click to close the shape");
  } else if (crossed.count(chain.size() - 2)) {
    draw_word(painter.list(), spot, window, theme, theme.amber, "This edge would cross another");
  } else {
    draw_word(painter.list(), spot, window, theme, theme.second_text,
              length_text(state, drawing.points.back(), *drawing.cursor));
  }
}

void draw_frame_grips(const Painter& painter, const AppState& state, const Theme& theme) {
  const Rect frame = transform_frame(state);
  ImDrawList& list = painter.list();
  const ImVec2 low = vec({frame.left, frame.top}), high = vec({frame.right, frame.bottom});
  list.AddRect(low, high, theme.accent.at(0.6f).packed(), 4, 0, 1.5f);
  const ImVec2 knob = vec(grip_place(frame, FrameGrip::turn));
  list.AddLine(ImVec2(knob.x, low.y), knob, theme.accent.at(0.6f).packed(), 1.5f);
  const auto grip = [&](FrameGrip which, bool round) {
    const ImVec2 at = vec(grip_place(frame, which));
    const Pick& named = state.held.kind == Pick::Kind::frame ? state.held : state.hover;
    const bool hot =
        named.kind == Pick::Kind::frame && named.index == static_cast<std::size_t>(which);
    if (hot) list.AddCircleFilled(at, 16, theme.accent.at(0.22f).packed(), 32);
    const float rounding = round ? 6.5f : 2.0f;
    const ImVec2 a(at.x - 6.5f, at.y - 6.5f), b(at.x + 6.5f, at.y + 6.5f);
    list.AddRectFilled(a, b, theme.panel.packed(), rounding);
    list.AddRect(a, b, theme.accent.packed(), rounding, 0, 2);
  };
  for (const FrameGrip corner : corner_grips) grip(corner, false);
  grip(FrameGrip::turn, true);
}

}  // namespace evenlift::view
