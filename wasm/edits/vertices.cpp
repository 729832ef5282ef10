#include "edits/vertices.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "edits/editing.h"
#include "evenlift/plane.h"
#include "state/notice.h"

namespace evenlift::view {

void insert_vertex(AppState& state, std::size_t edge, const Vec2& at) {
  if (edge >= state.work.document().vertices.size()) return;
  Document& document = edit(state, false, Edit::vertex_added);
  Points& vertices = document.vertices;
  const Vec2 &a = vertices[edge], &b = vertices[(edge + 1) % vertices.size()];
  const double part = std::clamp(dot(at - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  document.settings.no_go =
      after_split(document.settings.no_go, static_cast<std::uint32_t>(edge), part);
  if (state.work.aside.no_go)
    state.work.aside.no_go =
        after_split(*state.work.aside.no_go, static_cast<std::uint32_t>(edge), part);
  vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(edge) + 1, at);
  state.view.selected = edge + 1;
}

void remove_vertex(AppState& state, std::size_t vertex) {
  const std::size_t count = state.work.document().vertices.size();
  if (vertex >= count) return;
  if (count <= 3) {
    show(state, {Notice::Kind::problem, "A polygon needs at least 3 vertices."});
    return;
  }
  Document& document = edit(state, false, Edit::vertex_removed);
  Points& vertices = document.vertices;
  document.settings.no_go =
      after_removal(document.settings.no_go, vertices, static_cast<std::uint32_t>(vertex));
  if (state.work.aside.no_go)
    state.work.aside.no_go =
        after_removal(*state.work.aside.no_go, vertices, static_cast<std::uint32_t>(vertex));
  vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(vertex));
  state.view.selected.reset();
  state.view.hover = state.view.held = {};
  announce(state, "Vertex " + std::to_string(vertex + 1) + " removed.");
}

}  // namespace evenlift::view
