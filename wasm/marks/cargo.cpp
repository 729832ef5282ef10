#include "marks/cargo.h"

#include <algorithm>
#include <cmath>

#include "evenlift/output/words.h"
#include "marks/load_labels.h"
#include "tools/handles.h"
#include "tools/pick.h"
#include "ui/vec.h"

namespace evenlift::view {
namespace {

constexpr double least_radius = 5;      // pixels
constexpr double most_radius = 48;      // pixels, for an item that is all the weight
constexpr double most_share = 0.18;     // the same, of the object's size
constexpr double own_centre_reach = 7;  // pixels
constexpr std::size_t most_labelled_items = 60;

const std::vector<Cargo>& cargo_of(const CanvasView& view) {
  return view.state.work.document().settings.cargo;
}

double whole_radius(const CanvasView& view) {
  if (!view.placement) return most_radius;
  const double size = std::sqrt(view.placement->polygon().area()) * view.camera.scale;
  return std::min(most_radius, most_share * size);
}

std::string label_of(const Cargo& item, const Units& units) {
  return item.name.empty() ? given_weight(item.weight, units) : item.name;
}

void draw_disc(const Painter& painter, const Theme& theme, const CargoDisc& disc, bool marked) {
  ImDrawList& list = painter.list();
  const ImVec2 at = vec(disc.middle);
  const auto radius = static_cast<float>(disc.radius);
  const Colour line = marked ? theme.accent_on_object : theme.chord;
  if (marked) list.AddCircleFilled(at, radius + 9, theme.accent.at(0.22f).packed(), 48);
  list.AddCircle(at, radius + 1.5f, theme.object.packed(), 48, 1.5f);
  list.AddCircleFilled(at, radius, theme.object.at(0.75f).packed(), 48);
  list.AddCircleFilled(at, radius, line.at(0.4f).packed(), 48);
  list.AddCircle(at, radius, line.packed(), 48, 2);
  list.AddCircleFilled(at, 2.5f, line.packed(), 12);
}

}  // namespace

std::vector<CargoDisc> cargo_discs(const CanvasView& view) {
  const double total = total_weight(view.state.work.document().settings),
               whole = whole_radius(view);
  std::vector<CargoDisc> discs;
  for (const Cargo& item : cargo_of(view))
    discs.push_back({view.camera.to_screen(item.at),
                     std::max(least_radius, whole * std::sqrt(item.weight / total))});
  return discs;
}

std::vector<CargoLabel> cargo_labels(const CanvasView& view, Occupied& occupied) {
  const std::vector<Cargo>& cargo = cargo_of(view);
  if (cargo.size() > most_labelled_items) return {};
  const std::vector<CargoDisc> discs = cargo_discs(view);
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < cargo.size(); ++i) {
    if (!view.window.contains(discs[i].middle)) continue;
    texts.push_back(label_of(cargo[i], shown(view.state).units));
    const ImVec2 text = text_size(Face::label, texts.back());
    requests.push_back(
        {discs[i].middle, Vec2(1, 0), Vec2(text.x + 10, text.y + 4), discs[i].radius + 4});
  }
  const auto places = place_labels(requests, occupied, 0, cargo.size() <= 8 ? 60 : 8);
  std::vector<CargoLabel> labels;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i]) labels.push_back({*places[i], std::move(texts[i])});
  return labels;
}

void occupy_by_cargo(const CanvasView& view, Occupied& occupied) {
  const std::vector<CargoDisc> discs = cargo_discs(view);
  if (discs.empty()) return;
  for (const auto& [middle, radius] : discs) occupied.disc(middle, radius + 2);
  const Vec2 own = view.camera.to_screen(own_centre(view.state));
  occupied.disc(own, own_centre_reach);
  occupied.line(own, view.camera.to_screen(centre_of_mass(view.state)));
}

void draw_cargo(const Painter& painter, const CanvasView& view) {
  const std::vector<CargoDisc> discs = cargo_discs(view);
  if (discs.empty()) return;
  const std::size_t first = count_vertices(view.state.work.document());
  for (std::size_t i = 0; i < discs.size(); ++i)
    draw_disc(
        painter, view.theme, discs[i],
        is_hovered(view.state, Pick::Kind::cargo, i) || view.state.view.selected == first + i);
  if (!view.placement) return;
  for (const auto& [box, text] : labels_of_cargo(view)) {
    painter.list().AddRectFilled(vec(box.left, box.top), vec(box.right, box.bottom),
                                 view.theme.panel.at(0.88f).packed(), 6);
    draw_text(painter.list(), Face::label, vec(box.left + 5, box.top + 2), view.theme.text, text);
  }
}

void draw_own_centre(const Painter& painter, const CanvasView& view) {
  if (cargo_of(view).empty()) return;
  const Theme& theme = view.theme;
  const Vec2 own = own_centre(view.state);
  const ImVec2 at = painter.at(own);
  const bool hovered = is_hovered(view.state, Pick::Kind::centre, 0);
  painter.line(own, centre_of_mass(view.state), theme.chord, 1.5f);
  if (hovered) painter.list().AddCircleFilled(at, 14, theme.accent.at(0.22f).packed(), 32);
  painter.list().AddCircleFilled(at, 6.5f, theme.object.packed(), 24);
  painter.list().AddCircle(at, 5, (hovered ? theme.accent_on_object : theme.robot).packed(), 24,
                           hovered ? 2.5f : 1.5f);
}

}  // namespace evenlift::view
