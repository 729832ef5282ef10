#include "canvas/part_names.h"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/trace_words.h"
#include "evenlift/plane.h"
#include "ui/vec.h"

namespace evenlift::view {
namespace {

constexpr double ring = 15;  // pixels around a vertex of a step
constexpr double line = 5;   // beside an edge
constexpr double centre = 13;

// `from` is on the boundary. Returns `away` on the screen, or its opposite if `away` leads inside.
Vec2 outwards(const CanvasView& view, const Vec2& from, const Vec2& away) {
  const Points& vertices = view.placement->vertices();
  const Vec2 near = from + away * (3 / view.camera.scale);
  const Vec2 on_screen = view.camera.to_screen(from + away) - view.camera.to_screen(from);
  return on_screen / length(on_screen) * (inside(vertices, near) ? -1 : 1);
}

LabelRequest beside_edge(const CanvasView& view, const Points& edge) {
  const Vec2 along = edge[1] - edge[0], middle = (edge[0] + edge[1]) / 2;
  const Vec2 normal = Vec2(along.y, -along.x) / length(along);
  return {view.camera.to_screen(middle), outwards(view, middle, normal), Vec2{}, line};
}

LabelRequest beside_vertex(const CanvasView& view, const Vec2& vertex) {
  const Vec2 from_centre = vertex - view.placement->centre_of_mass;
  const double away = length(from_centre);
  const Vec2 direction = away > 0 ? Vec2(from_centre / away) : Vec2(0, 1);
  return {view.camera.to_screen(vertex), outwards(view, vertex, direction), Vec2{}, ring};
}

LabelRequest beside_centre(const CanvasView& view) {
  return {view.camera.to_screen(view.placement->centre_of_mass), Vec2(1, -1) / std::numbers::sqrt2,
          Vec2{}, centre};
}

}  // namespace

void draw_part_names(const Painter& painter, const CanvasView& view, Occupied& occupied) {
  std::vector<LabelRequest> requests;
  std::vector<std::string> names;
  const auto add = [&](LabelRequest request, std::string name) {
    const ImVec2 text = text_size(Face::label, name);
    request.size = Vec2(text.x + 10, text.y + 4);
    requests.push_back(request);
    names.push_back(std::move(name));
  };
  const Vec2 c = view.placement->centre_of_mass;
  for (const Figure& figure : view.state.view.walkthrough.figures) {
    const std::string name = part_name(figure);
    if (name.empty()) continue;
    if (figure.kind == FigureKind::vertex) {
      add(beside_vertex(view, figure.points[0]), name);
    } else if (figure.kind != FigureKind::centroid) {
      add(beside_edge(view, figure.points), name);
    } else if (length(figure.points[0] - c) * view.camera.scale > 2 * ring) {
      const Vec2 at = view.camera.to_screen(figure.points[0]);
      occupied.disc(at, ring);
      add({at, Vec2(1, -1) / std::numbers::sqrt2, Vec2{}, ring}, name);
    }
  }
  add(beside_centre(view), "C");
  const auto places = place_labels(requests, occupied, line, 1000);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const ImVec2 low = vec(places[i]->left, places[i]->top),
                 high = vec(places[i]->right, places[i]->bottom);
    painter.list().AddRectFilled(low, high, view.theme.panel.at(0.9f).packed(), 5);
    draw_text(painter.list(), Face::label, ImVec2(low.x + 5, low.y + 2), view.theme.text, names[i]);
  }
}

}  // namespace evenlift::view
