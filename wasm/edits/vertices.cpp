#include "edits/vertices.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "edits/placing.h"
#include "evenlift/plane.h"
#include "state/browser.h"
#include "state/notice.h"

namespace evenlift::view {

void insert_vertex(AppState& state, std::size_t edge, const Vec2& at) {
  Points& vertices = state.document.vertices;
  if (edge >= vertices.size()) return;
  begin_edit(state, false, Edit::vertex_added);
  const Vec2 &a = vertices[edge], &b = vertices[(edge + 1) % vertices.size()];
  const double part = std::clamp(dot(at - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  state.document.settings.no_go =
      after_split(settings(state).no_go, static_cast<std::uint32_t>(edge), part);
  if (state.aside.no_go)
    state.aside.no_go = after_split(*state.aside.no_go, static_cast<std::uint32_t>(edge), part);
  vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(edge) + 1, at);
  state.selected = edge + 1;
  recompute(state);
}

void remove_vertex(AppState& state, std::size_t vertex) {
  Points& vertices = state.document.vertices;
  if (vertex >= vertices.size()) return;
  if (vertices.size() <= 3) {
    show(state, {Notice::Kind::problem, "A polygon needs at least 3 vertices."});
    return;
  }
  begin_edit(state, false, Edit::vertex_removed);
  state.document.settings.no_go =
      after_removal(settings(state).no_go, vertices, static_cast<std::uint32_t>(vertex));
  if (state.aside.no_go)
    state.aside.no_go =
        after_removal(*state.aside.no_go, vertices, static_cast<std::uint32_t>(vertex));
  vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(vertex));
  state.selected.reset();
  state.hover = state.held = {};
  browser::announce("Vertex " + std::to_string(vertex + 1) + " removed.");
  recompute(state);
}

}  // namespace evenlift::view
