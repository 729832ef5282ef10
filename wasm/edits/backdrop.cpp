#include "edits/backdrop.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "edits/draw_polygon.h"
#include "edits/editing.h"
#include "evenlift/document.h"
#include "evenlift/wording.h"
#include "state/layout.h"

namespace evenlift::view {
namespace {

void show_all_of_it(AppState& state) {
  state.view.camera = fitting_camera(state);
  state.view.camera_follows = true;  // cards come and go beside it
}

struct Scaled {
  Vec2 low;
  double factor;
  Vec2 operator()(const Vec2& p) const { return (p - low) * factor; }
  void operator()(Points& points) const {
    for (Vec2& p : points) p = (*this)(p);
  }
  void operator()(std::optional<Vec2>& p) const {
    if (p) p = (*this)(*p);
  }
};

bool all_within(const Points& points, const Scaled& scaled) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec2& p) { return max_norm(scaled(p)) <= max_coordinate; });
}

void scale_drawing(AppState& state, const Scaled& scaled) {
  Drawing& drawing = state.view.drawing;
  for (Points* points : {&drawing.points, &drawing.undone}) scaled(*points);
  for (std::optional<Vec2>* cursor : {&drawing.cursor, &drawing.last_cursor}) scaled(*cursor);
  renew_drawing(state);
}

}  // namespace

void lay_behind(AppState& state, const Vec2& low, const Vec2& high) {
  state.work.backdrop = Backdrop{low, high, ++state.work.pictures};
  if (!draws(state.view.tool)) take_tool(state, Tool::draw);
  show_all_of_it(state);
}

void take_picture_away(AppState& state) { state.work.backdrop.reset(); }

std::string scale_picture(AppState& state, double width) {
  if (!state.work.backdrop) return {};
  const Scaled scaled{state.work.backdrop->low, width / state.work.backdrop->width()};
  const bool drawing = draws(state.view.tool), traced = !drawing && state.work.backdrop->traced;
  Points corners = drawing  ? state.view.drawing.points
                   : traced ? state.work.document().vertices
                            : Points();
  corners.push_back(state.work.backdrop->high);
  if (!(scaled.factor > 0) || !std::isfinite(scaled.factor)) return say("It would have no size");
  if (!all_within(corners, scaled))
    return say("The picture would reach beyond the largest coordinate");
  Document* document = traced ? &edit(state, false, Edit::whole) : nullptr;
  state.work.backdrop->high = scaled(state.work.backdrop->high);
  state.work.backdrop->low = Vec2(0, 0);
  if (drawing) scale_drawing(state, scaled);
  if (document) {
    scaled(document->vertices);
    for (Points& hole : document->holes) scaled(hole);
    for (Cargo& item : document->settings.cargo) item.at = scaled(item.at);
    scaled(document->centre_of_mass);
  }
  show_all_of_it(state);
  return {};
}

}  // namespace evenlift::view
