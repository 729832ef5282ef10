#include "marks/marks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "tools/drawing.h"
#include "tools/transform.h"
#include "ui/icons.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

// While the pointer is in the fields of the bar, the edge that they describe stays.
Points chain_with_cursor(const AppState& state, bool closing) {
  const Drawing& drawing = state.view.drawing;
  const std::optional<Vec2>& end =
      drawing.cursor || state.session.screen.touch ? drawing.cursor : drawing.last_cursor;
  Points chain = drawing.points;
  if (closing)
    chain.push_back(chain.front());
  else if (end)
    chain.push_back(*end);
  return chain;
}

// Before the first vertex is placed.
void draw_first_cursor(const Painter& painter, const AppState& state, const Theme& theme,
                       const Rect& free) {
  const std::optional<Vec2>& cursor = state.view.drawing.cursor;
  if (!cursor) return;
  painter.list().AddCircleFilled(painter.at(*cursor), 4, theme.accent.packed(), 16);
  draw_word(painter.list(), state.view.camera.to_screen(*cursor), free, theme, theme.second_text,
            given_point(*cursor));
}

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
    const bool placed = i + 1 < state.view.drawing.points.size();
    const Colour colour = crossed.count(i) ? theme.amber
                          : placed         ? theme.object_outline
                                           : theme.accent;
    painter.line(chain[i], chain[i + 1], colour, crossed.count(i) ? 3.5f : 2);
  }
}

// A press on the first vertex would close the shape.
void draw_placed(const Painter& painter, const AppState& state, const Theme& theme, bool closing) {
  const Drawing& drawing = state.view.drawing;
  const Pick& named =
      state.view.held.kind == Pick::Kind::vertex ? state.view.held : state.view.hover;
  ImDrawList& list = painter.list();
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    const ImVec2 at = painter.at(drawing.points[i]);
    const bool first = i == 0 && drawing.points.size() >= 3;
    if (first)
      list.AddCircleFilled(at, static_cast<float>(closing_reach),
                           theme.accent.at(closing ? 0.45f : 0.18f).packed(), 32);
    if (named.kind == Pick::Kind::vertex && named.index == i)
      list.AddCircleFilled(at, 18, theme.accent.at(0.22f).packed(), 36);
    list.AddCircleFilled(at, 4.5f, theme.panel.packed(), 20);
    list.AddCircle(at, 4.5f, (first ? theme.accent : theme.object_outline).packed(), 20, 2);
  }
}

// The first one.
std::optional<std::size_t> edge_crossed_by_last(const Points& chain) {
  for (const auto& [i, j] : crossings(chain))
    if (j + 2 == chain.size()) return i;
  return std::nullopt;
}

std::string closing_words(const AppState& state) {
  const bool hole = state.view.tool == Tool::hole;
  if (state.view.drawing.by_keys)
    return hole ? "Press Enter to close the hole" : "Press Enter to close the shape";
  if (state.session.screen.touch) return hole ? "Tap to close the hole" : "Tap to close the shape";
  return hole ? "Click to close the hole" : "Click to close the shape";
}

// The centroid of the shape, if it were closed now.
void draw_centroid(const Painter& painter, const Theme& theme, const Points& chain) {
  if (const std::optional<Vec2> centroid = centroid_of(chain))
    draw_centre_mark(painter.list(), painter.at(*centroid), 8, theme.second_text, theme.panel);
}

}  // namespace

void draw_edge_numbers(const Painter& painter, const Theme& theme, Colour colour,
                       const std::vector<NumberedEdge>& edges, std::vector<Rect> before) {
  for (const auto& [a, b, edge] : edges) {
    const std::string number = std::to_string(edge + 1);
    const ImVec2 text = text_size(Face::strong_label, number);
    const ImVec2 from = painter.at(a), to = painter.at(b);
    const Rect place = box_on_line(Vec2(from.x, from.y), Vec2(to.x, to.y),
                                   Vec2(text.x + 12, text.y + 6), from_middle, before);
    const ImVec2 low = vec(place.left, place.top), high = vec(place.right, place.bottom);
    painter.list().AddRectFilled(low, high, theme.panel.packed(), 6);
    painter.list().AddRect(low, high, colour.packed(), 6, 0, 1.5f);
    draw_text(painter.list(), Face::strong_label, ImVec2(low.x + 6, low.y + 3), colour, number);
  }
}

void draw_drawing(const Painter& painter, const AppState& state, const Theme& theme,
                  const Rect& free) {
  const Drawing& drawing = state.view.drawing;
  if (drawing.points.empty()) return draw_first_cursor(painter, state, theme, free);
  const bool closing =
      drawing.cursor && closes(state, state.view.camera.to_screen(*drawing.cursor));
  const Points chain = chain_with_cursor(state, closing);
  const std::set<std::size_t> crossed = crossed_edges(chain);
  draw_chain(painter, state, theme, chain, crossed);
  // The closing edge.
  if (!closing && chain.size() >= 3) painter.dashes(chain.back(), chain.front(), theme.quiet, 1.2f);
  draw_placed(painter, state, theme, closing);
  std::set<std::size_t> named = crossed;
  if (drawing.refusal && drawing.refusal->place.kind == Place::Kind::edge) {
    // A hole's other edge may be one of the object's.
    const Place& place = drawing.refusal->place;
    named.insert(place.index);
    if (place.other_ring == place.ring) named.insert(place.other);
  }
  std::vector<NumberedEdge> numbered;
  for (const std::size_t edge : named) {
    const Points& ring = edge + 1 < chain.size() ? chain : drawing.points;
    numbered.push_back({ring[edge % ring.size()], ring[(edge + 1) % ring.size()], edge});
  }
  draw_edge_numbers(painter, theme, theme.amber, numbered);
  if (crossed.empty() && state.view.tool == Tool::draw) draw_centroid(painter, theme, chain);
  if (!drawing.cursor) return;
  const Vec2 spot = state.view.camera.to_screen(*drawing.cursor);
  const Rect& window = free;
  if (closing) {
    if (drawing.refusal)
      draw_word(painter.list(), spot, window, theme, theme.amber,
                say("Cannot be closed: {reason}", {sentence(*drawing.refusal)}));
    else
      draw_word(painter.list(), spot, window, theme, theme.accent, closing_words(state));
  } else if (const auto other = edge_crossed_by_last(chain)) {
    draw_word(painter.list(), spot, window, theme, theme.amber,
              say("This edge would cross edge {edge}", {*other + 1}));
  } else if (*drawing.cursor != drawing.points.back()) {
    draw_word(painter.list(), spot, window, theme, theme.second_text,
              given_point(*drawing.cursor) + " · " +
                  edge_in_words(state, drawing.points.back(), *drawing.cursor));
  }
}

void draw_frame_grips(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  const Rect frame = transform_frame(state);
  ImDrawList& list = painter.list();
  const ImVec2 low = vec(frame.left, frame.top), high = vec(frame.right, frame.bottom);
  const bool held = state.view.held.kind == Pick::Kind::frame && state.work.edit_open;
  if (held && state.view.held.index == static_cast<std::size_t>(FrameGrip::turn)) {
    // The frame turns with the polygon until the knob is released.
    const Points corners = turned_frame(state);
    for (std::size_t i = 0; i < 4; ++i)
      list.AddLine(vec(corners[i]), vec(corners[(i + 1) % 4]), theme.accent.at(0.6f).packed(),
                   1.5f);
    const Vec2 knob = (corners[0] + corners[1]) / 2;
    list.AddCircleFilled(vec(knob), 6.5f, theme.accent.packed(), 24);
    return draw_word(list, knob, view.layout.free, theme, theme.text,
                     fixed(since_grip(state).degrees, 1) + "°");
  }
  list.AddRect(low, high, theme.accent.at(0.6f).packed(), 4, 0, 1.5f);
  const ImVec2 knob = vec(grip_place(state, frame, FrameGrip::turn));
  list.AddLine(ImVec2(knob.x, knob.y < low.y ? low.y : std::min(high.y, knob.y)), knob,
               theme.accent.at(0.6f).packed(), 1.5f);
  const auto grip = [&](FrameGrip which, bool round) {
    const ImVec2 at = vec(grip_place(state, frame, which));
    const Pick& named =
        state.view.held.kind == Pick::Kind::frame ? state.view.held : state.view.hover;
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
  if (held && state.view.held.index != static_cast<std::size_t>(FrameGrip::inside))
    draw_word(list, grip_place(state, frame, static_cast<FrameGrip>(state.view.held.index)),
              view.layout.free, theme, theme.text,
              fixed(100 * since_grip(state).factor, 1) + "\u00A0%");
}

}  // namespace evenlift::view
