#include "marks/centre.h"

#include <algorithm>
#include <optional>

#include "tools/pick.h"
#include "ui/icons.h"
#include "ui/vec.h"

namespace evenlift::view {
namespace {

// The knife edge on which the object balances.
void draw_tip(const Painter& painter, const ImVec2& tip, const Theme& theme, Colour colour) {
  const ImVec2 left(tip.x - 9, tip.y + 15), right(tip.x + 9, tip.y + 15);
  painter.list().AddTriangle(tip, left, right, theme.object.packed(), 5);
  painter.list().AddTriangleFilled(tip, left, right, colour.packed());
}

void draw_dashed_circle(ImDrawList& list, ImVec2 at, float radius, Colour colour) {
  const int dashes = std::clamp(static_cast<int>(radius * 0.6f), 12, 120);
  const float turn = 2 * 3.14159265f / static_cast<float>(dashes);
  for (int i = 0; i < dashes; ++i) {
    const float from = turn * static_cast<float>(i);
    list.PathArcTo(at, radius, from, from + turn * 0.6f, 6);
    list.PathStroke(colour.packed(), 0, 1.5f);
  }
}

}  // namespace

void draw_centre(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  const ImVec2 at = painter.at(centre_of_mass(state));
  if (view.placement && is_one_team(view.placement->settings.method))
    draw_tip(painter, ImVec2(at.x, at.y + 11), theme, theme.robot);
  // With cargo, the grip is the object's own centre of mass (cargo.h).
  const bool hovered = settings(state).cargo.empty() && is_hovered(state, Pick::Kind::centre, 0);
  if (hovered) painter.list().AddCircleFilled(at, 16, theme.accent.at(0.22f).packed(), 32);
  const bool wrong =
      state.derived().refusal && state.derived().refusal->place.kind == Place::Kind::centre_of_mass;
  painter.list().AddCircleFilled(at, 11.5f, theme.object.packed(), 32);
  draw_centre_mark(painter.list(), at, 9,
                   wrong     ? theme.amber_on_object
                   : hovered ? theme.accent_on_object
                             : theme.robot,
                   theme.object);
}

void draw_halo(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  if (!shown(state).overlays.halo || view.placement->teams.empty()) return;
  const Theme& theme = view.theme;
  ImDrawList& list = painter.list();
  const ImVec2 at = painter.at(centre_of_mass(state));
  // `known` is how far from C the weight may act: C is off, or the object tilts or brakes.
  const double margin = view.report().robustness.tipping_distance,
               known = effect_on({*view.placement, shown(state)}).reach;
  const auto in_pixels = [&](double length) {
    return static_cast<float>(std::min(length * view.camera.scale, 1e5));
  };
  if (margin > 0) draw_dashed_circle(list, at, in_pixels(margin), theme.hull_text);
  const Colour ring = known < margin ? theme.accent_on_object : theme.amber_on_object;
  if (known > 0) {
    list.AddCircleFilled(at, in_pixels(known), ring.at(0.12f).packed(), 64);
    list.AddCircle(at, in_pixels(known), ring.packed(), 64, 2);
  }
  const std::optional<Vec2> grip = uncertainty_grip(state);
  if (!grip || view.second) return;
  const ImVec2 spot = vec(grip->x, grip->y);
  const ImVec2 foot(at.x + in_pixels(known) * 0.70710678f, at.y - in_pixels(known) * 0.70710678f);
  const bool hot = is_hovered(state, Pick::Kind::uncertainty, 0);
  list.AddLine(foot, spot, ring.packed(), 1.5f);
  if (hot) list.AddCircleFilled(spot, 14, theme.accent.at(0.22f).packed(), 32);
  list.AddCircleFilled(spot, 6, theme.object.packed(), 24);
  list.AddCircle(spot, 6, ring.packed(), 24, 2);
}

}  // namespace evenlift::view
