#include "edits/vertices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "edits/editing.h"
#include "evenlift/plane.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "state/notice.h"
#include "tools/handles.h"

namespace evenlift::view {

namespace {

void put_in_hole(AppState& state, const Handle& edge, const Vec2& at) {
  Points& ring = ring_of(edit(state, false, Edit::vertex_added), edge.ring);
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(edge.index) + 1, at);
}

void remove_from_hole(AppState& state, const Handle& vertex) {
  const bool last = ring_of(state.work.document(), vertex.ring).size() <= 3;
  Document& document = edit(state, false, last ? Edit::hole_removed : Edit::vertex_removed);
  Points& ring = ring_of(document, vertex.ring);
  if (last)
    document.holes.erase(document.holes.begin() + static_cast<std::ptrdiff_t>(vertex.ring) - 1);
  else
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(vertex.index));
}

void remove_from_outline(AppState& state, std::size_t vertex) {
  Document& document = edit(state, false, Edit::vertex_removed);
  Points& vertices = document.vertices;
  document.settings.no_go =
      after_removal(document.settings.no_go, vertices, static_cast<std::uint32_t>(vertex));
  if (state.work.aside.no_go)
    state.work.aside.no_go =
        after_removal(*state.work.aside.no_go, vertices, static_cast<std::uint32_t>(vertex));
  vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(vertex));
}

void remove_weight(AppState& state, std::size_t item) {
  std::vector<Cargo>& cargo = edit(state, false, Edit::weight_removed).settings.cargo;
  cargo.erase(cargo.begin() + static_cast<std::ptrdiff_t>(item));
}

// A tenth of the object's own weight, with one digit.
double usual_weight(const Settings& settings) {
  const double tenth = settings.weight / 10, unit = std::pow(10, std::floor(std::log10(tenth)));
  return std::clamp(std::round(tenth / unit) * unit, min_weight, max_weight);
}

}  // namespace

void move_handle(AppState& state, std::size_t number, const Vec2& to) {
  const std::optional<Handle> handle = handle_of(state.work.document(), number);
  if (!handle || place_of(state.work.document(), number) == to) return;
  put(edit(state, true, handle->is_weight ? Edit::weight_moved : Edit::vertex_moved), number, to);
}

void insert_vertex(AppState& state, std::size_t edge, const Vec2& at) {
  const std::optional<Handle> handle = handle_of(state.work.document(), edge);
  if (!handle || handle->is_weight) return;
  state.view.selected = edge + 1;
  if (handle->ring > 0) return put_in_hole(state, *handle, at);
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
}

void remove_handle(AppState& state, std::size_t number) {
  const std::optional<Handle> handle = handle_of(state.work.document(), number);
  if (!handle) return;
  if (!handle->is_weight && handle->ring == 0 && state.work.document().vertices.size() <= 3) {
    show(state, {Notice::Kind::problem, "A polygon needs at least 3 vertices."});
    return;
  }
  const std::string name = name_of(state.work.document(), number);
  const std::size_t holes = state.work.document().holes.size();
  if (handle->is_weight)
    remove_weight(state, handle->index);
  else if (handle->ring > 0)
    remove_from_hole(state, *handle);
  else
    remove_from_outline(state, handle->index);
  state.view.selected.reset();
  state.view.hover = state.view.held = {};
  const bool whole_hole = state.work.document().holes.size() < holes;
  announce(state, whole_hole ? say("Hole {hole} removed.", {handle->ring})
                             : say("{part} removed.", {name}));
}

void add_weight(AppState& state, const Vec2& at) {
  if (state.work.document().settings.cargo.size() == max_cargo)
    return show(state, {Notice::Kind::problem, "There can be at most 1000 weights."});
  Document& document = edit(state, false, Edit::weight_added);
  document.settings.cargo.push_back({at, usual_weight(document.settings), {}});
  state.view.selected = count_handles(document) - 1;
  announce(state, say("{part} added.", {name_of(document, *state.view.selected)}));
}

std::string problem_of(const Cargo& item) {
  const auto is_refused = [](const Cargo& cargo) {
    Settings settings;
    settings.cargo = {cargo};
    return check_ranges(settings).has_value();
  };
  if (!is_refused(item)) return {};
  return say(is_refused({item.at, item.weight, {}})
                 ? "A weight must be a number greater than 0, at most 1e100, at a place within 1e9"
                 : "The name of a weight must be text of at most 60 characters");
}

void set_weight(AppState& state, std::size_t item, const Cargo& cargo) {
  if (const std::string problem = problem_of(cargo); !problem.empty())
    return show(state, {Notice::Kind::problem, problem + "."});
  const std::vector<Cargo>& now = state.work.document().settings.cargo;
  if (item >= now.size() || now[item] == cargo) return;
  edit(state, false, Edit::weight_changed).settings.cargo[item] = cargo;
}

void grip_polygon(AppState& state) { state.view.grip = grip_of(state.work.document()); }

}  // namespace evenlift::view
