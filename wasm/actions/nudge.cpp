#include "actions/nudge.h"

#include "actions/when.h"
#include "state/layout.h"
#include "tools/drawing.h"
#include "tools/transform.h"

namespace evenlift::view {

void move_cursor(const AppState& s, Commands& out, int x, int y, bool finely) {
  const Drawing& d = s.drawing;
  Vec2 at = d.cursor            ? *d.cursor
            : !d.points.empty() ? d.points.back()
                                : nearest_dot(s.camera, s.camera.to_world(layout(s).free.middle()));
  const bool begins = !d.cursor && d.points.empty();  // the first press shows the cursor
  if (!begins) {
    const double step = finely ? 1 / s.camera.scale : grid_step(s.camera);
    const Vec2 wanted = at + Vec2(x * step, y * step);
    const Vec2 to = finely ? rounded_finely(s.camera, wanted) : nearest_dot(s.camera, wanted);
    if (x != 0)
      at.x() = to.x();
    else
      at.y() = to.y();
  }
  out.push_back(SetDrawCursor{at, {}, true});
}

void nudge(const AppState& s, Commands& out, int x, int y) {
  if (when::drawing(s)) return move_cursor(s, out, x, y, false);
  if (when::transforming(s)) return out.push_back(moved_polygon(s, x, y));
  if (when::on_robot(s)) {
    const Vec2 along = Vec2(x, y) * (grid_step(s.camera) / 10);
    out.push_back(MoveRobot{*s.explanation->robot, s.explanation->of.at + along});
    return out.push_back(EndEdit{});
  }
  const double step = grid_step(s.camera) / (s.snap.grid ? 1 : 10);
  const Vec2 to = s.document.vertices[*s.selected] + Vec2(x * step, y * step);
  out.push_back(MoveVertex{
      *s.selected, s.snap.grid ? nearest_dot(s.camera, to) : rounded_to_pixels(s.camera, to)});
  out.push_back(EndEdit{});
}

}  // namespace evenlift::view
